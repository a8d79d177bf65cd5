import { expect, test } from 'vitest'
import { softStack } from './soft-stack'

/** px that a spring of this frequency gives way under its own box: g/ω². */
const ownSag = (hertz: number) => 2600 / (2 * Math.PI * hertz) ** 2

test('a box on a soft contact comes to rest where spring and weight balance', () => {
  expect(softStack(1, 30, 600).at(-1)![0]).toBeCloseTo(ownSag(30), 6)
  expect(softStack(1, 60, 600).at(-1)![0]).toBeCloseTo(ownSag(60), 6)
})

test('in a column every contact gives way under all that it carries', () => {
  const [first, second, third] = softStack(3, 30, 1200).at(-1)!
  // The floor's contact moves one box; one between two boxes has half the mass, and so half the stiffness.
  expect(first).toBeCloseTo(3 * ownSag(30), 3)
  expect(second - first).toBeCloseTo(2 * 2 * ownSag(30), 3)
  expect(third - second).toBeCloseTo(2 * ownSag(30), 3)
})
