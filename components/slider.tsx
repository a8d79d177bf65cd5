import { type ReactNode, useId } from 'react'

/** A slider with its value beside its name; a screen reader hears that as the slider's own. */
export function Slider({
  label,
  value,
  min,
  max,
  step = 1,
  unit,
  onChange,
}: {
  label: ReactNode
  value: number
  min: number
  max: number
  step?: number
  unit?: string
  onChange: (value: number) => void
}) {
  const id = useId()
  const space = unit && !unit.startsWith('°') ? '\u00a0' : ''
  const said = `${value.toLocaleString('en')}${space}${unit ?? ''}`
  return (
    <div className="min-w-[min(10rem,100%)] flex-1">
      <div className="flex justify-between gap-4">
        <label htmlFor={id}>{label}</label>
        <span aria-hidden="true" className="text-muted-foreground tabular-nums">
          {said}
        </span>
      </div>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-valuetext={said}
        onChange={(event) => onChange(Number(event.target.value))}
        className="mt-1 w-full accent-foreground"
      />
    </div>
  )
}
