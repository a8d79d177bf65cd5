// Makes random scenes from a seed, and the same ones from the same seed. Whole numbers wherever they do, so
// that what a failure shrinks to can be read.
import fc from 'fast-check'
import { type Act, apart, type FuzzScene } from '../../scenes/fuzzed'
import type { Chip, Conditions } from '../../scenes/scene'

/** What nobody should write, and somebody will. */
const odd = fc.constantFrom(
  Number.NaN,
  Number.POSITIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  -1,
  0,
  1e9,
  -1e9,
  1e308,
)

/** Mostly `sound`, now and then odd. */
const mostly = (sound: fc.Arbitrary<number>, weight = 30) =>
  fc.oneof({ withCrossShrink: true }, { arbitrary: sound, weight }, { arbitrary: odd, weight: 1 })
const whole = (min: number, max: number) => fc.integer({ min, max })
/** Steps of a tenth. */
const tenths = (min: number, max: number) => whole(10 * min, 10 * max).map((n) => n / 10)

const length = fc.oneof(
  { withCrossShrink: true },
  { arbitrary: whole(10, 120), weight: 6 },
  { arbitrary: whole(2, 200), weight: 2 },
  { arbitrary: whole(2, 2000), weight: 1 },
)
const radius = fc.oneof(
  { withCrossShrink: true },
  { arbitrary: fc.constant(0), weight: 2 },
  { arbitrary: fc.constant(1000), weight: 3 },
  whole(1, 40),
)

const chip = (oddly: number, speed: number): fc.Arbitrary<Chip> =>
  fc.record({
    width: mostly(length, oddly),
    height: mostly(length, oddly),
    radius: mostly(radius, oddly),
    x: mostly(whole(0, 1000), oddly),
    y: mostly(whole(-200, 600), oddly),
    angle: mostly(tenths(-4, 4), oddly),
    vx: mostly(whole(-speed, speed), oddly),
    vy: mostly(whole(-speed, speed), oddly),
    spin: mostly(tenths(-Math.ceil(speed / 200), Math.ceil(speed / 200)), oddly),
    density: fc.oneof({ arbitrary: fc.constant(1), weight: 8 }, mostly(fc.constantFrom(0.1, 10), oddly)),
  })

const usual: Conditions = {
  gravity: 2600,
  bounce: 0.18,
  friction: 0.4,
  bounceThreshold: 90,
  linearDamping: 0.35,
  angularDamping: 1.4,
}

const conditions = (oddly: number): fc.Arbitrary<Conditions> =>
  fc.oneof(
    { withCrossShrink: true },
    { arbitrary: fc.constant(usual), weight: 2 },
    {
      arbitrary: fc.record({
        gravity: mostly(fc.oneof(fc.constantFrom(0, 100, 2600, 20_000), whole(0, 20_000)), oddly),
        bounce: mostly(tenths(0, 1), oddly),
        friction: mostly(tenths(0, 2), oddly),
        bounceThreshold: mostly(fc.constantFrom(90, 0, 1000), oddly),
        linearDamping: mostly(fc.constantFrom(0.35, 0, 5), oddly),
        angularDamping: mostly(fc.constantFrom(1.4, 0, 5), oddly),
      }),
      weight: 1,
    },
  )

const act: fc.Arbitrary<Act> = fc.oneof(
  fc.record({ frame: whole(1, 90), do: fc.constant('remove' as const), chip: whole(0, 11) }),
  fc.record({
    frame: whole(1, 90),
    do: fc.constant('resize' as const),
    width: mostly(whole(100, 1000)),
    height: mostly(whole(100, 600)),
  }),
  fc.record({
    frame: whole(1, 90),
    do: fc.constant('reshape' as const),
    chip: whole(0, 11),
    width: mostly(length),
    height: mostly(length),
    radius: mostly(radius),
  }),
  fc.record({
    frame: whole(1, 90),
    do: fc.constant('place' as const),
    chip: whole(0, 11),
    x: mostly(whole(-100, 1100)),
    y: mostly(whole(-200, 700)),
  }),
  fc.record({
    frame: whole(1, 90),
    do: fc.constant('configure' as const),
    gravity: mostly(whole(0, 20_000)),
  }),
  fc.record({
    frame: whole(1, 60),
    do: fc.constant('drag' as const),
    chip: whole(0, 11),
    x: mostly(whole(-500, 1500)),
    y: mostly(whole(-500, 1000)),
  }),
)

const scene = (oddly: number, speed: number, acts: number, chips = 12): fc.Arbitrary<FuzzScene> =>
  fc.record({
    width: mostly(whole(100, 1000), oddly),
    height: mostly(whole(100, 600), oddly),
    conditions: conditions(oddly),
    chips: fc.array(chip(oddly, speed), { minLength: 1, maxLength: chips }),
    acts: fc.array(act, { maxLength: acts }),
  })

const never = 1e9

/** Four in ten as the component drops them, the rest ever wilder. */
export const anyScene: fc.Arbitrary<FuzzScene> = fc.oneof(
  { arbitrary: scene(never, 200, 0).map(apart), weight: 4 },
  { arbitrary: scene(never, 0, 0), weight: 2 },
  { arbitrary: scene(never, 3600, 0).map(apart), weight: 1 },
  { arbitrary: scene(never, 200, 4).map(apart), weight: 1 },
  { arbitrary: scene(30, 5000, 0), weight: 1 },
  { arbitrary: scene(10, 5000, 6), weight: 1 },
)
