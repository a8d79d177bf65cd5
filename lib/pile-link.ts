// A pile as an address: what was done to it since its drop, so that the same steps make the same pile again.

/** px, in 16ths; s, in tenths of a millisecond: what people do, as short as it may be written. */
export const inPixels = (value: number) => Math.round(value * 16) / 16
export const inSeconds = (value: number) => Math.round(value * 1e4) / 1e4

/** What was done, after how many steps. A hand and a chip are numbers, counted from 0. */
export type Act =
  | [at: number, what: 'resize', width: number, height: number]
  | [at: number, what: 'reshape', chip: number, width: number, height: number, radius: number]
  | [at: number, what: 'configure', ...Configured]
  | [at: number, what: 'obstacle', x: number, y: number, width: number, height: number, radius: number]
  | [at: number, what: 'clear']
  | [at: number, what: 'push', radius: number, ...Way]
  | [at: number, what: 'grab', hand: number, chip: number, x: number, y: number]
  | [at: number, what: 'move', hand: number, x: number, y: number, seconds: number]
  | [at: number, what: 'release', hand: number]

/** Gravity to the right and downwards, 1 for a closed top, bounce and friction. */
export type Configured = [
  gravityX: number,
  gravityY: number,
  ceiling: number,
  bounce: number,
  friction: number,
]
/** From where and by how much a disc goes, px, and how long that takes, s. */
export type Way = [x: number, y: number, goX: number, goY: number, seconds: number]

export type PileRecord = {
  /** of the component that it was recorded with */
  version: string
  /** as the drop began */
  options: {
    width: number
    height: number
    gravity: { x: number; y: number }
    ceiling: boolean
    bounce: number
    friction: number
    stagger: number
    seed: number
  }
  /** width, height and corner radius of each chip, px: another browser's fonts make other chips */
  shapes: [width: number, height: number, radius: number][]
  acts: Act[]
  steps: number
  /** of the world after the last step */
  hash: string
}

/** What a link can hold: ten minutes, and an address of some tens of kilobytes. */
const longest = { chips: 60, steps: 36_000, acts: 20_000 }
export const fits = ({ shapes, acts, steps }: Pick<PileRecord, 'shapes' | 'acts' | 'steps'>) =>
  shapes.length <= longest.chips && steps <= longest.steps && acts.length <= longest.acts

const name = 'pile'

async function through(bytes: BodyInit, stream: CompressionStream | DecompressionStream) {
  const body = new Response(bytes).body!
  return new Uint8Array(await new Response(body.pipeThrough(stream)).arrayBuffer())
}

/** The part of an address behind its `#`: JSON, deflated, in letters that an address may hold. */
export async function toFragment(record: PileRecord): Promise<string> {
  const packed = await through(JSON.stringify(record), new CompressionStream('deflate-raw'))
  const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''))
  return `${name}=${letters.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`
}

/** The pile of an address, or undefined where it has none. Rejects where what it has can't be played. */
export async function fromFragment(hash: string): Promise<PileRecord | undefined> {
  const text = new URLSearchParams(hash.replace(/^#/, '')).get(name)
  if (text === null) return
  const packed = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) =>
    letter.charCodeAt(0),
  )
  const json = new TextDecoder().decode(await through(packed, new DecompressionStream('deflate-raw')))
  const record = JSON.parse(json)
  if (!isRecord(record)) throw new Error('This address holds no pile that can be played.')
  return record
}

const isNumbers = (values: unknown): values is number[] =>
  Array.isArray(values) && values.every((value) => Number.isFinite(value))

/** Numbers that follow the name of each act. */
const lengths: Record<Act[1], number> = {
  resize: 2,
  reshape: 4,
  configure: 5,
  obstacle: 5,
  clear: 0,
  push: 6,
  grab: 4,
  move: 4,
  release: 1,
}

/**
 * Anyone may have written an address: a record is played only if every number is one, and every chip there is
 * meant.
 */
function isRecord(it: PileRecord): boolean {
  const numbers = ['width', 'height', 'bounce', 'friction', 'stagger', 'seed'] as const
  if (!it || typeof it.version !== 'string' || typeof it.hash !== 'string') return false
  if (!it.options || !numbers.every((key) => Number.isFinite(it.options[key]))) return false
  const { gravity, ceiling } = it.options
  if (!isNumbers([gravity?.x, gravity?.y]) || typeof ceiling !== 'boolean') return false
  if (!Array.isArray(it.shapes) || !it.shapes.every((shape) => isNumbers(shape) && shape.length === 3))
    return false
  if (!Array.isArray(it.acts) || !Number.isInteger(it.steps) || it.steps < 0 || !fits(it)) return false
  let before = 0
  return it.acts.every((act) => {
    if (!Array.isArray(act)) return false
    const [at, what, ...rest] = act
    const chip = what === 'grab' ? rest[1] : what === 'reshape' ? rest[0] : 0
    const meant = chip !== undefined && chip in it.shapes
    const later = Number.isInteger(at) && at >= before && at <= it.steps
    before = at
    return later && meant && rest.length === lengths[what] && isNumbers(rest)
  })
}
