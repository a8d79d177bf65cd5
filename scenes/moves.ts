// Piles at rest to which something is done: the stage becomes narrower, turns or grows, or the chips grow.
import { aired, type HardScene, onGrid, pour, settles } from './hard'

const stage = { width: 640, height: 340 }
/** Frame and moment of the first move: all have slept for a while by then. */
const first = 300
const begun = first / 60

/** px of overlap that a moving wall or a growing chip may press into a pile on the way. */
const bounds = { ...settles, asleep: 10, 'overlap during': 1 }

const pile = {
  ...stage,
  conditions: aired,
  seconds: begun + 14,
  overlapFrom: begun,
}

/** A pile of 60 in a stage that loses a third of its width, so many px a frame. */
function narrowed(step: number): HardScene {
  const frames = Math.ceil(stage.width / 3 / step)
  return {
    ...pile,
    name: `narrowed-by-${step}`,
    title: `The stage becomes a third narrower, ${step} px a frame`,
    seeds: 20,
    build: (seed) => pour('pills', 60, seed),
    act(frame, actor) {
      const k = frame - first
      if (k >= 0 && k < frames)
        actor.resize(onGrid(Math.max((2 / 3) * stage.width, stage.width - step * (k + 1))), 340)
    },
    calmFrom: begun + frames / 60,
    bounds,
  }
}

export const moves: HardScene[] = [
  narrowed(1.3),
  narrowed(4),
  narrowed(10),
  {
    ...pile,
    name: 'halved',
    title: 'The stage becomes half as wide at once',
    seeds: 20,
    build: (seed) => pour('pills', 30, seed),
    act(frame, actor) {
      if (frame === first) actor.resize(stage.width / 2, 340)
    },
    calmFrom: begun,
    bounds,
  },
  {
    ...pile,
    name: 'turned',
    title: 'The stage turns from landscape to portrait at once',
    seeds: 40,
    build: (seed) => pour('mixed', 60, seed),
    act(frame, actor) {
      if (frame === first) actor.resize(375, 500)
    },
    calmFrom: begun,
    bounds,
  },
  {
    ...pile,
    name: 'turned-and-back',
    title: 'The stage turns to portrait and, three seconds later, back',
    seeds: 20,
    build: (seed) => pour('mixed', 60, seed),
    act(frame, actor) {
      if (frame === first) actor.resize(375, 500)
      if (frame === first + 180) actor.resize(640, 340)
    },
    calmFrom: begun + 3,
    bounds,
  },
  {
    ...pile,
    name: 'chips-grown',
    title: 'All chips grow by a fifth at once',
    seeds: 40,
    build: (seed) => pour('mixed', 60, seed),
    act(frame, actor, seed) {
      if (frame !== first) return
      for (const [i, { width, height, radius = 0 }] of pour('mixed', 60, seed).entries())
        actor.reshape(i, { width: 1.2 * width, height: 1.2 * height, radius: 1.2 * radius })
    },
    calmFrom: begun,
    bounds,
  },
  {
    ...pile,
    name: 'stage-grown',
    title: 'The stage grows by 0.3 to 1.4 px, five times',
    seeds: 40,
    build: (seed) => pour('mixed', 5, seed),
    act(frame, actor, seed) {
      const k = (frame - first) / 60
      if (!Number.isInteger(k) || k < 0 || k > 4) return
      const more = onGrid((0.3 + 1.1 * ((0.618 * seed) % 1)) * (k + 1))
      actor.resize(640 + more, 340 + more)
    },
    calmFrom: begun + 4,
    bounds,
  },
]
