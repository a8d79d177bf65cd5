import { expect, test } from 'vitest'
import {
  chipsOf,
  codeOf,
  defaults,
  elevationNote,
  fromQuery,
  gravityOf,
  looks,
  shapes,
  toQuery,
} from './playground'

test('an untouched playground has a clean address', () => {
  expect(toQuery(defaults)).toBe('')
  expect(fromQuery('')).toEqual(defaults)
})

test('settings survive the way through the address', () => {
  const settings = {
    ...defaults,
    words: 'a & b, c=d, ü',
    shape: 'mixed' as const,
    look: 'ink' as const,
    count: 7,
    gravity: 0,
    direction: -135,
    ceiling: true,
    push: 44,
    obstacle: true,
    obstacleX: 30.25,
    obstacleY: 80,
    bounce: 1,
    seed: 3,
    interactive: false,
    upright: false,
  }
  expect(fromQuery(toQuery(settings))).toEqual(settings)
})

test('numbers out of range are brought into it, nonsense is left at its default', () => {
  const settings = fromQuery('count=-5&gravity=1e99&bounce=high&stagger=&shape=star')
  expect(settings).toEqual({ ...defaults, count: 1, gravity: 8000 })
})

test('numbers between the steps of a slider go to the nearest', () => {
  expect(fromQuery('count=3.7&gravity=2649&bounce=0.574')).toMatchObject({
    count: 4,
    gravity: 2600,
    bounce: 0.57,
  })
})

test('words that somebody has taken out stay out', () => {
  expect(fromQuery(toQuery({ ...defaults, words: '' })).words).toBe('')
  expect(fromQuery('words=%20').words).toBe(' ')
})

test('no words make chips all the same', () => {
  expect(chipsOf({ ...defaults, words: ' , ,', count: 2 }).map(({ word }) => word)).toEqual(['chip', 'chip'])
})

test('a word may go over lines; in the code it stands on one', () => {
  expect(codeOf({ ...defaults, words: 'one\n  two,\tthree\r\n' })).toContain(
    "const words = ['one two', 'three']\n",
  )
})

test('code that needs the elevation tokens says so first', () => {
  expect(codeOf({ ...defaults, look: 'neutral' }).startsWith(elevationNote)).toBe(true)
  expect(codeOf(defaults)).toMatch(/^import /)
})

test('the code has every prop that is set, and no other', () => {
  const props = 'gravity={100} bounce={1} friction={0} stagger={0} interactive={false} upright={false}'
  const set = { gravity: 100, bounce: 1, friction: 0, stagger: 0, interactive: false, upright: false }
  expect(codeOf({ ...defaults, ...set })).toContain(`<GravityStack ${props} className="h-96">`)
  expect(codeOf(defaults)).toContain('<GravityStack className="h-96">')
})

test('the code names gravity by its two parts where it points aside, a ceiling, a push and the obstacle', () => {
  expect(codeOf({ ...defaults, direction: 90, push: 44, ceiling: true })).toContain(
    '<GravityStack gravity={{ x: 2600, y: 0 }} ceiling push={44} className="h-96">\n      {Array',
  )
  expect(codeOf({ ...defaults, obstacle: true, obstacleX: 30.25 })).toContain(
    '<GravityStack className="h-96">\n      <div data-static className="absolute top-[60%] left-[30.25%] h-6 ',
  )
  expect(codeOf({ ...defaults, direction: 90, gravity: 0 })).toContain('<GravityStack gravity={0} class')
})

test('gravity that points up closes the top, in the code too', () => {
  expect(gravityOf({ gravity: 2600, direction: 180 })).toEqual({ x: 0, y: -2600 })
  expect(codeOf({ ...defaults, direction: 180 })).toContain('gravity={{ x: 0, y: -2600 }} ceiling class')
})

test('the code has every class of the chips on the stage', () => {
  for (const shape of shapes) {
    for (const look of looks) {
      const code = codeOf({ ...defaults, shape, look })
      for (const { className } of chipsOf({ ...defaults, shape, look }))
        for (const name of className.split(' ')) expect(code).toContain(name)
    }
  }
})
