import { type ReactNode, useId } from 'react'
import { looks, ranges, type Settings, shapes } from '@/lib/playground'
import { Slider } from '../slider'

/** A field for each of the settings. */
export function Fields({
  settings,
  change,
}: {
  settings: Settings
  change: (next: Partial<Settings>) => void
}) {
  const { words, count, shape, look, gravity, bounce, friction, stagger, interactive, upright, seed } =
    settings
  return (
    <>
      <Field label="Words, with commas between">
        {(id) => (
          <textarea
            id={id}
            rows={3}
            maxLength={500}
            value={words}
            onChange={(event) => change({ words: event.target.value })}
            className="w-full resize-y rounded-md border border-input bg-background px-3 py-2"
          />
        )}
      </Field>
      <Choice label="Shape" value={shape} options={shapes} onChange={(value) => change({ shape: value })} />
      <Choice label="Look" value={look} options={looks} onChange={(value) => change({ look: value })} />
      <Range of="count" label="Chips" value={count} onChange={change} />
      <Range of="gravity" label="gravity" unit="px/s²" value={gravity} onChange={change} />
      <Range of="bounce" label="bounce" value={bounce} onChange={change} />
      <Range of="friction" label="friction" value={friction} onChange={change} />
      <Range of="stagger" label="stagger" unit="ms" value={stagger} onChange={change} />
      <Range of="seed" label="Seed (not in the code)" value={seed} onChange={change} />
      <Switch of="upright" value={upright} onChange={change} />
      <Switch of="interactive" value={interactive} onChange={change} />
      <p className="-mt-3 text-muted-foreground">
        Here chips can only be dragged; in the component a tap makes one hop, too.
      </p>
    </>
  )
}

function Field({ label, children }: { label: string; children: (id: string) => ReactNode }) {
  const id = useId()
  return (
    <div className="flex flex-col gap-1.5">
      <label htmlFor={id}>{label}</label>
      {children(id)}
    </div>
  )
}

function Range({
  of,
  label,
  unit,
  value,
  onChange,
}: {
  of: keyof typeof ranges
  label: string
  unit?: string
  value: number
  onChange: (next: Partial<Settings>) => void
}) {
  const [min, max, step] = ranges[of]
  return (
    <Slider
      // Props have their name as it is in the code.
      label={<span className={label === of ? 'font-mono text-[0.8125rem]' : undefined}>{label}</span>}
      value={value}
      min={min}
      max={max}
      step={step}
      unit={unit}
      onChange={(next) => onChange({ [of]: next })}
    />
  )
}

function Switch({
  of,
  value,
  onChange,
}: {
  of: 'interactive' | 'upright'
  value: boolean
  onChange: (next: Partial<Settings>) => void
}) {
  return (
    <label className="flex items-center gap-3">
      <input
        type="checkbox"
        checked={value}
        onChange={(event) => onChange({ [of]: event.target.checked })}
        className="size-4 accent-foreground"
      />
      <span className="font-mono text-[0.8125rem]">{of}</span>
    </label>
  )
}

function Choice<Value extends string>({
  label,
  value,
  options,
  onChange,
}: {
  label: string
  value: Value
  options: readonly Value[]
  onChange: (value: Value) => void
}) {
  return (
    <Field label={label}>
      {(id) => (
        <select
          id={id}
          value={value}
          onChange={(event) => onChange(event.target.value as Value)}
          className="w-full rounded-md border border-input bg-background px-3 py-2"
        >
          {options.map((option) => (
            <option key={option}>{option}</option>
          ))}
        </select>
      )}
    </Field>
  )
}
