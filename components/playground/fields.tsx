import { type ReactNode, useId } from 'react'
import { gravityOf, isClosed, looks, ranges, type Settings, shapes } from '@/lib/playground'
import { Slider } from '../slider'

/** A field for each of the settings. */
export function Fields({
  settings,
  change,
}: {
  settings: Settings
  change: (next: Partial<Settings>) => void
}) {
  const { words, count, shape, look, gravity, direction, push, bounce, friction, stagger } = settings
  const { interactive, upright, seed, obstacle, obstacleX, obstacleY } = settings
  const rises = gravityOf(settings).y < 0
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
      <Range
        of="direction"
        label="Direction it pulls in"
        unit={pointsTo[direction] ?? '°'}
        value={direction}
        onChange={change}
      />
      <Switch of="ceiling" value={isClosed(settings)} disabled={rises} onChange={change} />
      {rises && <p className="-mt-3 text-muted-foreground">Closed, as gravity points up.</p>}
      <Range of="push" label="push" unit="px" value={push} onChange={change} />
      {push > 0 && (
        <p className="-mt-3 text-muted-foreground">
          {interactive ? 'A mouse that moves over the stage shoves chips aside.' : 'Needs interactive.'}
        </p>
      )}
      <Range of="bounce" label="bounce" value={bounce} onChange={change} />
      <Range of="friction" label="friction" value={friction} onChange={change} />
      <Range of="stagger" label="stagger" unit="ms" value={stagger} onChange={change} />
      <Range of="seed" label="Seed (not in the code)" value={seed} onChange={change} />
      <Switch of="obstacle" label="Obstacle" value={obstacle} onChange={change} />
      {obstacle && (
        <>
          <p className="-mt-3 text-muted-foreground">
            Drag it, or move it with the arrow keys once it has the focus.
          </p>
          <Range of="obstacleX" label="Obstacle from the left" unit="%" value={obstacleX} onChange={change} />
          <Range of="obstacleY" label="Obstacle from the top" unit="%" value={obstacleY} onChange={change} />
        </>
      )}
      <Switch of="upright" value={upright} onChange={change} />
      <Switch of="interactive" value={interactive} onChange={change} />
      <p className="-mt-3 text-muted-foreground">
        Here chips can only be dragged; in the component a tap makes one hop, too.
      </p>
    </>
  )
}

/** What is said of a direction, degrees from straight down. */
const pointsTo: Record<number, string> = {
  0: '° down',
  90: '° right',
  [-90]: '° left',
  180: '° up',
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
  label,
  value,
  disabled,
  onChange,
}: {
  of: 'ceiling' | 'interactive' | 'obstacle' | 'upright'
  label?: string
  value: boolean
  disabled?: boolean
  onChange: (next: Partial<Settings>) => void
}) {
  return (
    <label className="flex items-center gap-3">
      <input
        type="checkbox"
        checked={value}
        disabled={disabled}
        onChange={(event) => onChange({ [of]: event.target.checked })}
        className="size-4 accent-foreground"
      />
      <span className={label ? undefined : 'font-mono text-[0.8125rem]'}>{label ?? of}</span>
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
