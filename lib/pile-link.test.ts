import { expect, test } from 'vitest'
import { createRecorder, createReplay } from '@/components/lab/recorder'
import { fits, fromFragment, type PileRecord, toFragment } from './pile-link'

const options = { width: 400, height: 300, gravity: 2600, bounce: 0.18, friction: 0.4, stagger: 100, seed: 7 }

/** A pile of six pills to which everything is done that can be. */
function played() {
  const pills = Array.from({ length: 6 }, (_, i) => ({ width: 70 + i, height: 30, radius: 15 }))
  const recorder = createRecorder('1.2.3', options, pills)
  const step = (times: number) => {
    for (let k = 0; k < times; k++) recorder.step()
  }
  step(90)
  const { world, ids } = recorder.pile
  const { x, y } = world.read(ids[2])
  const hand = recorder.grab(2, x + 1 / 3, y)
  for (let k = 0; k < 12; k++) {
    hand.moveTo(x + 7 * k, y - 11 * k, 1234.567_89 + k / 60)
    step(1)
  }
  hand.release()
  step(20)
  recorder.resize(320, 300)
  recorder.reshape(0, { width: 90, height: 40, radius: 8 })
  recorder.configure(1200, 0.4, 0.2)
  step(150)
  return recorder.record()!
}

test('a pile that was recorded is played again to the last bit, by way of an address', async () => {
  const record = played()
  const fragment = await toFragment(record)
  expect(fragment).toMatch(/^pile=[\w-]+$/)
  const read = await fromFragment(`#${fragment}`)
  expect(read).toEqual(record)
  const replay = createReplay(read!)
  while (!replay.over) replay.step()
  expect(replay.steps).toBe(record.steps)
  expect(replay.same).toBe(true)
  // What was done counts: without the hand it is another pile.
  const idle = createReplay({ ...record, acts: record.acts.filter(([, what]) => what !== 'grab') })
  while (!idle.over) idle.step()
  expect(idle.same).toBe(false)
})

test('an address without a pile has none, and one that anyone has written can be refused', async () => {
  expect(await fromFragment('')).toBeUndefined()
  expect(await fromFragment('#benchmarks')).toBeUndefined()
  await expect(fromFragment('#pile=nonsense')).rejects.toThrow()
  const record = played()
  const wrong: Partial<Record<keyof PileRecord, unknown>>[] = [
    { version: 1 },
    { options: { ...options, gravity: 'much' } },
    { options: undefined },
    { shapes: [[10, 10]] },
    { shapes: Array(61).fill([10, 10, 0]) },
    { steps: 1e9 },
    { steps: 10 },
    { acts: [[0, 'grab', 0, 99, 0, 0]] },
    { acts: [[0, 'explode']] },
    {
      acts: [
        [5, 'release', 0],
        [4, 'release', 0],
      ],
    },
    { acts: [[0, 'resize', 100, null]] },
  ]
  for (const part of wrong)
    await expect(
      fromFragment(await toFragment({ ...record, ...part } as PileRecord)),
      JSON.stringify(part),
    ).rejects.toThrow('no pile')
})

test('a pile that was played with for longer than an address can hold is not recorded', () => {
  const { shapes, acts, steps } = played()
  expect(fits({ shapes, acts, steps })).toBe(true)
  expect(fits({ shapes, acts, steps: 36_001 })).toBe(false)
  expect(fits({ shapes, acts: Array(20_001).fill(acts[0]), steps })).toBe(false)
})
