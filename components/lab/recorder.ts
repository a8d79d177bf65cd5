import { type Act, fits, inPixels, inSeconds, type PileRecord, type Way } from '@/lib/pile-link'
import { cornerRadius, type Shape } from '@/scenes/exact-distance'
import { createPile, type Obstacle, type Pile } from './pile'

type Options = PileRecord['options']
type Configurable = 'gravity' | 'ceiling' | 'bounce' | 'friction'
type Doing = Act extends [number, ...infer Rest] ? Rest : never

/** Does what a record tells to a pile, one act after the other. */
function performer(pile: Pile) {
  const { world, ids, shapes } = pile
  const grabs = new Map<number, ReturnType<typeof world.grab>>()
  return ([, ...act]: Act) => {
    const { revision } = world.scene
    if (act[0] === 'resize') world.resize(act[1], act[2])
    else if (act[0] === 'configure') {
      const [, x, y, ceiling, bounce, friction] = act
      world.configure({ gravity: { x, y }, ceiling: ceiling > 0, bounce, friction })
    } else if (act[0] === 'obstacle') {
      const [, x, y, width, height, radius] = act
      pile.setObstacle({ x, y, width, height, radius })
    } else if (act[0] === 'clear') pile.setObstacle(undefined)
    else if (act[0] === 'push') world.push(act[1], act[2], act[3], act[4], act[5], act[6])
    else if (act[0] === 'reshape') {
      const [, chip, width, height, radius] = act
      const shape = { width, height, radius }
      shapes[chip] = shape
      if (ids[chip] !== undefined) world.reshape(ids[chip], { ...shape, radius: cornerRadius(shape) })
    } else if (act[0] === 'grab') {
      const [, hand, chip, x, y] = act
      if (ids[chip] !== undefined) grabs.set(hand, world.grab(ids[chip], x, y))
    } else if (act[0] === 'move') grabs.get(act[1])?.moveTo(act[2], act[3], act[4])
    else grabs.get(act[1])?.release()
    // A push may meet nothing, and is not noted then.
    if (act[0] !== 'push' || world.scene.revision !== revision) pile.touch()
  }
}

const shapesOf = (record: Pick<PileRecord, 'shapes'>) =>
  record.shapes.map(([width, height, radius]): Shape => ({ width, height, radius }))

/** A drop that is being played: a new one, or one that was recorded. */
export type Player = {
  pile: Pile
  step(): void
  /** True when a recorded one has been played to its end. */
  over: boolean
}

export type Recorder = ReturnType<typeof createRecorder>

/**
 * A pile that notes what is done to it. All of it passes here, so that nothing is done which is not noted.
 */
export function createRecorder(version: string, options: Options, sizes: Shape[]) {
  const shapes = sizes.map(({ width, height, radius = 0 }): PileRecord['shapes'][number] => [
    width,
    height,
    radius,
  ])
  const pile = createPile(options, shapesOf({ shapes }))
  const perform = performer(pile)
  const acts: Act[] = []
  let steps = 0
  let hands = 0
  /** s, the time of the first move: clocks count from whenever they like. */
  let begun: number | undefined
  let size = [options.width, options.height].join()
  let obstacle = ''

  function act(...doing: Doing) {
    const next = [steps, ...doing] as Act
    acts.push(next)
    perform(next)
  }

  return {
    pile,
    over: false,
    step() {
      steps++
      pile.step()
    },
    resize(width: number, height: number) {
      if ([width, height].join() === size) return
      size = [width, height].join()
      act('resize', width, height)
    },
    reshape: (chip: number, { width, height, radius = 0 }: Shape) =>
      act('reshape', chip, width, height, radius),
    configure: ({ gravity, ceiling, bounce, friction }: Pick<Options, Configurable>) =>
      act('configure', gravity.x, gravity.y, Number(ceiling), bounce, friction),
    /** Puts the obstacle somewhere, or takes it away. */
    setObstacle(body: Obstacle | undefined) {
      const next = body ? [body.x, body.y, body.width, body.height, body.radius].map(inPixels) : []
      if (next.join() === obstacle) return
      obstacle = next.join()
      if (body) act('obstacle', ...(next as [number, number, number, number, number]))
      else act('clear')
    },
    /** A disc of `radius` px goes a way. A push that meets no chip is not noted: it changes nothing. */
    push(radius: number, [x, y, goX, goY, seconds]: Way) {
      const { revision } = pile.world.scene
      const way = [...[x, y, goX, goY].map(inPixels), inSeconds(seconds)] as Way
      const next: Act = [steps, 'push', radius, ...way]
      perform(next)
      const met = pile.world.scene.revision !== revision
      if (met) acts.push(next)
      return met
    },
    /** A hand takes a chip at a point of the stage. */
    grab(chip: number, x: number, y: number) {
      const hand = hands++
      act('grab', hand, chip, inPixels(x), inPixels(y))
      return {
        moveTo(x: number, y: number, seconds: number) {
          begun ??= seconds
          act('move', hand, inPixels(x), inPixels(y), inSeconds(seconds - begun))
        },
        release: () => act('release', hand),
      }
    },
    /** What was done up to now; nothing where that is too much for a link. */
    record(): PileRecord | undefined {
      if (!fits({ shapes, acts, steps })) return
      return { version, options, shapes, acts: [...acts], steps, hash: pile.world.hash() }
    },
  }
}

/** Plays a recorded pile, step by step. */
export function createReplay(record: PileRecord) {
  const { options, acts } = record
  const pile = createPile(options, shapesOf(record))
  const perform = performer(pile)
  let steps = 0
  let next = 0
  const actUpToNow = () => {
    while (next < acts.length && acts[next][0] <= steps) perform(acts[next++])
  }
  actUpToNow()
  return {
    pile,
    get steps() {
      return steps
    },
    get over() {
      return steps >= record.steps
    },
    step() {
      if (steps >= record.steps) return
      steps++
      pile.step()
      actUpToNow()
    },
    /** Whether the pile is, in the end, the recorded one to the last bit. */
    get same() {
      return pile.world.hash() === record.hash
    },
  }
}
