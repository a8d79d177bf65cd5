import { expect, it } from 'vitest'
import { type Facts, nextState } from './state'

const dropping: Facts = { still: false, ready: true, paused: false, settled: false, shown: true }

it.each([
  ['drops its chips', {}, 'running'],
  ['has come to rest', { settled: true }, 'resting'],
  ['has come to rest and is scrolled away', { settled: true, shown: false }, 'resting'],
  ['is scrolled away while chips fall', { shown: false }, 'paused'],
  ['is paused by its caller while chips fall', { paused: true }, 'paused'],
  ['is paused by its caller at rest', { paused: true, settled: true }, 'paused'],
  ['has not come into view', { ready: false }, 'waiting'],
  ['has not come into view and is paused already', { ready: false, paused: true }, 'waiting'],
  ['has no world yet, so that nothing can move', { ready: false, settled: true, shown: false }, 'waiting'],
  ['prefers reduced motion, whatever else holds', { still: true }, 'static'],
  ['prefers reduced motion before it came into view', { still: true, ready: false }, 'static'],
  ['prefers reduced motion while it is paused', { still: true, paused: true, settled: true }, 'static'],
] satisfies [string, Partial<Facts>, string][])('a stage that %s', (_, facts, state) => {
  expect(nextState({ ...dropping, ...facts })).toBe(state)
})
