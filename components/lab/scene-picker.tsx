import { useEffect, useId, useState } from 'react'

type Named = { name: string; title: string; seeds: number }
type Picked<Scene> = { scene: Scene; seed: number }

/**
 * The scene that is picked, at first the one called `first`, and the one to play, which follows once the
 * choice is seen: the page may be busy with it for seconds.
 */
export function usePick<Scene extends Named>(scenes: readonly Scene[], first: string) {
  const [picked, pick] = useState<Picked<Scene>>(() => ({
    scene: scenes.find(({ name }) => name === first)!,
    seed: 1,
  }))
  const [played, play] = useState(picked)
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout>
    const request = requestAnimationFrame(() => {
      timer = setTimeout(play, 0, picked)
    })
    return () => {
      cancelAnimationFrame(request)
      clearTimeout(timer)
    }
  }, [picked])
  return { picked, pick, ...played }
}

/** Which scene a figure shows, and from which seed: another scene begins at its first. */
export function ScenePicker<Scene extends Named>({
  scenes,
  picked: { scene, seed },
  onPick,
}: {
  scenes: readonly Scene[]
  picked: Picked<Scene>
  onPick: (pick: Picked<Scene>) => void
}) {
  const id = useId()
  return (
    <>
      <div className="flex min-w-0 flex-1 basis-64 flex-col gap-1.5">
        <label htmlFor={id}>Scene</label>
        <select
          id={id}
          value={scene.name}
          onChange={(event) => onPick({ scene: scenes[event.target.selectedIndex], seed: 1 })}
          className="w-full rounded-md border border-input bg-background px-3 py-2"
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
          onClick={() => onPick({ scene, seed: (seed % scene.seeds) + 1 })}
          className="rounded-md border px-3 py-2 tabular-nums hover:bg-muted"
        >
          Seed {seed} of {scene.seeds}: next
        </button>
      )}
    </>
  )
}
