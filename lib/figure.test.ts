import { expect, test } from 'vitest'
import { figure } from './figure'

test('a figure has three digits, and powers of ten where zeros would have to be counted', () => {
  expect([0, 0.18, 0.00427, 41.28, 7856, 99_940].map(figure)).toEqual([
    '0',
    '0.18',
    '0.00427',
    '41.3',
    '7,860',
    '99,900',
  ])
  expect([1e-9, 2.31e-13, 1.13e10, -4e-5].map(figure)).toEqual([
    '10⁻⁹',
    '2.3\u00a0·\u00a010⁻¹³',
    '1.1\u00a0·\u00a010¹⁰',
    '-4.0\u00a0·\u00a010⁻⁵',
  ])
  expect([null, undefined, Number.POSITIVE_INFINITY].map(figure)).toEqual(['–', '–', '∞'])
})
