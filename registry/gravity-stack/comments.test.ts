import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, it } from 'vitest'

const folders = ['.', 'solver', 'stage', 'testing'].map((name) => join(__dirname, name))
const files = folders.flatMap((folder) =>
  readdirSync(folder)
    .filter((name) => /\.tsx?$/.test(name))
    .map((name) => join(folder, name)),
)

it('no comment of the component is wider than its code, 110 columns', () => {
  const wide = files.flatMap((file) =>
    readFileSync(file, 'utf8')
      .split('\n')
      .filter((line) => /^\s*(\/\/|\/?\*)/.test(line) && line.length > 110),
  )
  expect(wide).toEqual([])
})
