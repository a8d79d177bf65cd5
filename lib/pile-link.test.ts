import { expect, test } from 'vitest'
import { createRecorder, createReplay } from '@/components/lab/recorder'
import { fits, fromFragment, type PileRecord, toFragment } from './pile-link'

const options = {
  width: 400,
  height: 300,
  gravity: { x: 0, y: 2600 },
  ceiling: false,
  bounce: 0.18,
  friction: 0.4,
  stagger: 100,
  seed: 7,
}

/** A pile of six pills to which everything is done that can be. */
function played() {
  const pills = Array.from({ length: 6 }, (_, i) => ({ width: 70 + i, height: 30, radius: 15 }))
  const recorder = createRecorder('1.2.3', options, pills)
  const step = (times: number) => {
    for (let k = 0; k < times; k++) recorder.step()
  }
  recorder.setObstacle({ x: 200, y: 180, width: 144, height: 20, radius: 10 })
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
  recorder.configure({ gravity: { x: 700, y: 900 }, ceiling: true, bounce: 0.4, friction: 0.2 })
  step(60)
  for (let k = 0; k < 30; k++) {
    recorder.push(40, [10 * k, 280, 10, 0, 1 / 60])
    step(1)
  }
  recorder.setObstacle({ x: 260 + 1 / 3, y: 250, width: 144, height: 20, radius: 10 })
  step(60)
  recorder.setObstacle(undefined)
  step(60)
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
  // What was done counts: without one kind of it, it is another pile.
  for (const left of ['grab', 'obstacle', 'push']) {
    const other = createReplay({ ...record, acts: record.acts.filter(([, what]) => what !== left) })
    while (!other.over) other.step()
    expect(other.same, left).toBe(false)
  }
})

test('an address without a pile has none, and one that anyone has written can be refused', async () => {
  expect(await fromFragment('')).toBeUndefined()
  expect(await fromFragment('#benchmarks')).toBeUndefined()
  await expect(fromFragment('#pile=nonsense')).rejects.toThrow()
  const record = played()
  const wrong: Partial<Record<keyof PileRecord, unknown>>[] = [
    { version: 1 },
    { options: { ...options, gravity: 'much' } },
    { options: { ...options, gravity: { x: 0 } } },
    { options: { ...options, ceiling: undefined } },
    { acts: [[0, 'obstacle', 100, 100]] },
    { acts: [[0, 'push', 40, 0, 0, 10, 0, 'soon']] },
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

test('a mouse that pushes nothing leaves nothing in the record', () => {
  const recorder = createRecorder('1.2.3', options, [{ width: 70, height: 30, radius: 15 }])
  for (let k = 0; k < 200; k++) recorder.step()
  const { acts, hash } = recorder.record()!
  expect(recorder.push(40, [10, 20, 300, 0, 1 / 60])).toBe(false)
  expect(recorder.record()).toMatchObject({ acts, hash })
})

test('chips that sideways gravity leaves above an open stage come in again, and so they are played again', async () => {
  const recorder = createRecorder('1.2.3', { ...options, gravity: { x: 2600, y: 0 }, stagger: 0 }, [
    { width: 70, height: 30, radius: 15 },
    { width: 80, height: 30, radius: 15 },
  ])
  const { pile } = recorder
  const rest = () => {
    do recorder.step()
    while (!pile.resting)
  }
  rest()
  const { x, y } = pile.world.read(pile.ids[0])
  const hand = recorder.grab(0, x, y)
  for (let k = 0; k < 30; k++) {
    hand.moveTo(x, y - 20 * k, k / 60)
    recorder.step()
  }
  hand.release()
  rest()
  for (const id of pile.ids) expect(pile.world.read(id).y).toBeGreaterThan(0)
  const replay = createReplay(recorder.record()!)
  while (!replay.over) replay.step()
  expect(replay.same).toBe(true)
})

test('a pile that was played with for longer than an address can hold is not recorded', () => {
  const { shapes, acts, steps } = played()
  expect(fits({ shapes, acts, steps })).toBe(true)
  expect(fits({ shapes, acts, steps: 36_001 })).toBe(false)
  expect(fits({ shapes, acts: Array(20_001).fill(acts[0]), steps })).toBe(false)
})
