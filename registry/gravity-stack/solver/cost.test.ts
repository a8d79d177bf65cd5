import { Session } from 'node:inspector/promises'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { Script } from 'node:vm'
import { build } from 'esbuild'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Chip } from '../../../scenes/scene'
import type { settle as Settle, worldOf as WorldOf } from '../testing/worlds'
import { CONTACT } from './state'

// What does not have to run, does not run: counted by the engine itself, function by function and block by
// block, so that the component carries no counters for it.

const here = dirname(fileURLToPath(import.meta.url))
const frame = 1 / 60
const session = new Session()
let source = ''
let worldOf: typeof WorldOf
let settle: typeof Settle

beforeAll(async () => {
  const { outputFiles } = await build({
    entryPoints: [join(here, '../testing/worlds.ts')],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'modules',
    target: 'es2022',
  })
  source = `${outputFiles[0].text}modules`
  session.connect()
  await session.post('Profiler.enable')
  // Before the code is compiled: blocks compiled without counters are never counted.
  await session.post('Profiler.startPreciseCoverage', { callCount: true, detailed: true })
  ;({ worldOf, settle } = new Script(source, { filename: 'modules.js' }).runInThisContext())
})

/**
 * Counts what runs during `work`: calls of a function, or how often the block of it that holds `text` was
 * entered.
 */
async function counted(work: () => void) {
  await session.post('Profiler.takePreciseCoverage')
  work()
  const { result } = await session.post('Profiler.takePreciseCoverage')
  const functions = result.filter(({ url }) => url === 'modules.js').flatMap((script) => script.functions)
  return (name: string, text?: string) => {
    const start = source.indexOf(`function ${name}(`)
    if (start < 0) throw new Error(`There is no function ${name}`)
    const at = text ? source.indexOf(text, start) : start
    if (at < 0) throw new Error(`${name} holds no ${text}`)
    const own = functions.find((found) => found.functionName === name)
    // Ranges come from the outside in. A function that did not run is not listed.
    const ranges = own?.ranges.filter(({ startOffset, endOffset }) => startOffset <= at && at < endOffset)
    return ranges?.at(-1)?.count ?? 0
  }
}

const size = { width: 40, height: 40, angle: 0 }
const kinds: Record<string, { width: number; height: number; radius: number }> = {
  pills: { width: 80, height: 30, radius: 15 },
  discs: { width: 36, height: 36, radius: 18 },
  boxes: { width: 60, height: 36, radius: 0 },
}
/** Rows of chips in the air that fall onto each other. */
const crowd = (kind: string): Chip[] =>
  Array.from({ length: 24 }, (_, i) => ({
    ...kinds[kind],
    x: 60 + (i % 6) * 100 + 7 * Math.floor(i / 6),
    y: 280 - 60 * Math.floor(i / 6),
    angle: 0.2 * (i % 3),
  }))

const fall = (chips: Chip[], options = {}) =>
  counted(() => {
    expect(settle(worldOf(chips, options).world, 900)).toBeLessThan(900)
  })

describe('what the scene does not need is not run', () => {
  it('in free flight nothing is measured, and no contact is visited', async () => {
    const chips = Array.from({ length: 20 }, (_, i) => ({ ...size, x: 100 + 300 * i, y: 100, vx: 50 }))
    const { world } = worldOf(chips, { width: 7000, height: 100_000 })
    const ran = await counted(() => {
      for (let k = 0; k < 60; k++) world.step(frame)
    })
    expect(ran('updateBox')).toBe(20 * 60)
    for (const needless of ['updateContact', 'collide', 'addContact', 'solveImpact'])
      expect([needless, ran(needless)]).toEqual([needless, 0])
    expect(world.stats.rows).toBe(0)
  })

  it('of a pile partly awake only what is awake and what it touches is worked on', async () => {
    const tower = (x: number) => [0, 1, 2, 3, 4].map((i) => ({ ...size, x, y: 320 - 40 * i }))
    const { world, ids } = worldOf([...tower(120), ...tower(520)])
    settle(world)
    const { bodies, contacts } = world.scene
    const sleeping = new Set(ids.slice(5))
    const records = () =>
      Array.from({ length: contacts.count }, (_, c) => c)
        .filter((c) => sleeping.has(contacts.pair[2 * c + 1]))
        .map((c) => Array.from(contacts.data.subarray(c * CONTACT, (c + 1) * CONTACT)))
    const poses = () => ids.slice(5).map((id) => world.read(id))
    const before = { records: records(), poses: poses() }
    expect(before.records.length).toBeGreaterThanOrEqual(5)
    world.add({ ...kinds.pills, x: 120, y: 60 })
    let most = 0
    const ran = await counted(() => {
      for (let k = 0; k < 120; k++) {
        world.step(frame)
        most = Math.max(most, world.stats.awake)
        for (const id of sleeping) expect(bodies.asleep[id]).toBe(1)
      }
    })
    expect(most).toBeLessThanOrEqual(6)
    expect(ran('updateBox')).toBeLessThanOrEqual(6 * 6 * 120)
    // Not a number in a record of the other tower has changed.
    expect({ records: records(), poses: poses() }).toEqual(before)
  })

  it('once all sleep, and before the first chip, a step does nothing at all', async () => {
    const { world } = worldOf(crowd('pills'))
    expect(settle(world, 900)).toBeLessThan(900)
    for (const idle of [world, worldOf([]).world]) {
      const ran = await counted(() => {
        for (let k = 0; k < 60; k++) idle.step(frame)
      })
      for (const needless of [
        'substep',
        'updatePairs',
        'updateBox',
        'iterate',
        'updateContact',
        'collide',
        'keepInside',
      ])
        expect([needless, ran(needless)]).toEqual([needless, 0])
    }
  })

  it('of a row on the floor only the contacts of the chip that slides are solved, though all stand on the same floor', async () => {
    const row = Array.from({ length: 13 }, (_, i) => ({ ...kinds.boxes, angle: 0, x: 40 + 60.5 * i, y: 322 }))
    const { world, ids } = worldOf(row, { width: 1000, sleep: false })
    for (let k = 0; k < 60; k++) world.step(frame)
    world.place(ids[12], { vx: 60 })
    world.step(frame)
    const { substeps, rows } = world.stats
    expect(substeps).toBeGreaterThan(1)
    // Its contact with the floor, until that stands still, and that with the chip next to it.
    expect(rows).toBeGreaterThanOrEqual(substeps)
    expect(rows).toBeLessThanOrEqual(5 * substeps)
  })

  it('among discs no two normals are solved at once', async () => {
    expect((await fall(crowd('discs')))('iterate', 'const q1')).toBe(0)
    expect((await fall(crowd('pills')))('iterate', 'const q1')).toBeGreaterThan(100)
  })
})
