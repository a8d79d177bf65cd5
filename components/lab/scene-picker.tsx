import { useId } from 'react'

type Named = { name: string; title: string; seeds: number }

/** Which scene a figure shows, and from which seed: another scene begins at its first. */
export function ScenePicker({
  scenes,
  scene,
  seed,
  onPick,
}: {
  scenes: readonly Named[]
  scene: Named
  seed: number
  onPick: (name: string, seed: number) => void
}) {
  const id = useId()
  return (
    <>
      <div className="flex min-w-0 flex-1 basis-64 flex-col gap-1.5">
        <label htmlFor={id}>Scene</label>
        <select
          id={id}
          value={scene.name}
          onChange={(event) => onPick(event.target.value, 1)}
          className="w-full rounded-md border bg-background px-3 py-2"
        >
          {scenes.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </div>
      {scene.seeds > 1 && (
        <button
          type="button"
          onClick={() => onPick(scene.name, (seed % scene.seeds) + 1)}
          className="rounded-md border px-3 py-2 tabular-nums hover:bg-muted"
        >
          Seed {seed} of {scene.seeds}: next
        </button>
      )}
    </>
  )
}
