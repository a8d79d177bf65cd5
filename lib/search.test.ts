import { expect, test } from 'vitest'
import { type Entry, excerpt, marked, search } from './search'

const entry = (kind: Entry['kind'], title: string, text: string, page = 'Gravity Stack'): Entry => ({
  kind,
  title,
  page,
  text,
  href: `/${title}`,
})

const entries = [
  entry('Section', 'Motion', 'Reduced motion is a matter of CSS.', 'Accessibility'),
  entry('Section', 'Pointer', 'Motion that is reduced by a swipe.', 'Accessibility'),
  entry('Prop', 'gravity', 'Downward acceleration.'),
  entry('Page', 'Gravity Stack', 'Children drop in and don’t stop.'),
  entry('Recipe', 'Fewer chips on phones', 'Hide what is too much.', 'Recipes'),
]
const titles = (query: string) => search(entries, query).map(({ title }) => title)

test('words side by side come before the same words apart', () => {
  expect(titles('reduced motion')).toEqual(['Motion', 'Pointer'])
})

test('a title that is the query comes first, capitals or not', () => {
  expect(titles('Gravity')[0]).toBe('gravity')
  expect(titles('gravity stack')[0]).toBe('Gravity Stack')
})

test('a word that is only begun is found, and one by its kind', () => {
  expect(titles('accel')).toEqual(['gravity'])
  expect(titles('phones recipe')).toEqual(['Fewer chips on phones'])
})

test('a straight apostrophe finds a curly one', () => {
  expect(titles("don't")).toEqual(['Gravity Stack'])
})

test('a word that stands nowhere does not hide what the others find; alone it finds nothing', () => {
  expect(titles('prefers-reduced-motion')).toEqual(['Motion', 'Pointer'])
  expect(titles('zebra')).toEqual([])
  expect(titles(' - ')).toEqual([])
})

test('an excerpt shows the words, cut at spaces, and begins a text that has none of them', () => {
  const text = `${'before '.repeat(30)}the reduced motion row ${'after '.repeat(30)}`
  expect(excerpt(text, 'reduced motion')).toMatch(/^…(before )+the reduced motion row (after ?)+…$/)
  expect(excerpt(text, 'zebra')).toMatch(/^before .*before…$/)
  expect(excerpt('short', 'zebra')).toBe('short')
})

test('the beginnings of words that the query has are marked, whatever signs it has', () => {
  const hits = (text: string, query: string) =>
    marked(text, query)
      .filter(({ hit }) => hit)
      .map(({ piece }) => piece)
  expect(hits('Reduced motion, emotion', 'motion reduced')).toEqual(['Reduced', 'motion'])
  expect(hits('It can’t', "can't")).toEqual(['can’t'])
  expect(hits('drop()', 'drop( [')).toEqual(['drop'])
  expect(marked('drop', '')).toEqual([{ piece: 'drop', hit: false }])
})
