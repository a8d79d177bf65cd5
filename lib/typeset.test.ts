import { expect, test } from 'vitest'
import { rehypeTypeset, typeset } from './typeset'

test('apostrophes are curly, and a number keeps its unit on its line', () => {
  expect(typeset("it can't rest at 3 px/s after 0.5 s")).toBe('it can’t rest at 3\u00a0px/s after 0.5\u00a0s')
  expect(typeset('at 400 % zoom, 2 stages')).toBe('at 400\u00a0% zoom, 2 stages')
  expect(typeset('at e = 1')).toBe('at e\u00a0=\u00a01')
})

test('code stays as it was written', () => {
  const page = {
    type: 'root',
    children: [
      { type: 'text', value: "it's" },
      { type: 'element', tagName: 'code', children: [{ type: 'text', value: "Couldn't take 5 s" }] },
    ],
  }
  rehypeTypeset()(page)
  expect(page.children[0].value).toBe('it’s')
  expect(page.children[1].children?.[0].value).toBe("Couldn't take 5 s")
})
