import { execFileSync } from 'node:child_process'
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'

const root = join(import.meta.dirname, '..')
const read = (path: string) => readFileSync(join(root, path), 'utf8')

const records = new Map(
  readdirSync(join(root, 'docs/decisions')).map((name) => [name.slice(0, 5), read(`docs/decisions/${name}`)]),
)

/** Every committed or new file that people write, by its path. */
const sources = new Map(
  execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
    cwd: root,
    encoding: 'utf8',
  })
    .split('\n')
    .filter((path) => /\.(tsx?|mjs|mdx?|css|json)$/.test(path) && !path.startsWith('public/'))
    .filter((path) => existsSync(join(root, path)))
    .map((path) => [path, read(path)]),
)
const code = [...sources]
  .filter(([path]) => /\.(tsx?|mjs|css)$/.test(path) && path !== 'docs/decisions.test.ts')
  .map(([, text]) => text)
  .join('\n')
const paths = [...sources.keys()]
const scripts: Record<string, string> = JSON.parse(read('package.json')).scripts

const quoted = (text: string) =>
  [...text.matchAll(/`([^`]+)`/g)].map(([, inner]) => inner.replace(/\s+/g, ' '))

/** The part of a record that begins with this word. */
const part = (record: string, word: string) =>
  record.match(new RegExp(`^\\**${word}\\b[\\s\\S]*?(?=\\n\\n|\\n*$(?![\\s\\S]))`, 'm'))?.[0] ?? ''

/** What a command names that is not there. */
function missing(command: string) {
  const [tool, ...words] = command
    .replace(/^npx /, '')
    .replace(/"[^"]*"/g, '')
    .split(' ')
    .filter(Boolean)
  if (tool === 'npm') return scripts[words[0] === 'run' ? words[1] : words[0]] ? [] : [words.join(' ')]
  if (tool === 'tsx') return existsSync(join(root, words[0])) ? [] : [words[0]]
  const suffix = tool === 'vitest' ? '.test.ts' : '.spec.ts'
  const filters = words.filter(
    (word, n) => !/^-|^(run|test)$/.test(word) && !/^-[gt]$/.test(words[n - 1] ?? ''),
  )
  return filters.filter((word) => !paths.some((path) => path.endsWith(suffix) && path.includes(word)))
}

test('every record that is cited anywhere exists', () => {
  const cited = [...sources].flatMap(([path, text]) =>
    (path === 'docs/decisions.test.ts' ? [] : (text.match(/\bD-0\d\d\b/g) ?? [])).map(
      (id) => `${id} ${path}`,
    ),
  )
  expect(cited.filter((line) => !records.has(line.slice(0, 5)))).toEqual([])
})

for (const [id, record] of records) {
  test(`${id} is short, explains something that exists, and says what shows its figures`, () => {
    expect(record.trimEnd().split('\n').length).toBeLessThanOrEqual(30)
    const explained = quoted(part(record, 'Explains'))
    expect(explained).not.toEqual([])
    expect(
      explained.filter((name) => !code.includes(name) && !paths.some((path) => path.endsWith(name))),
    ).toEqual([])
    const commands = quoted(part(record, 'Shown by')).filter((text) => /^np[mx] /.test(text))
    expect(commands).not.toEqual([])
    expect(commands.flatMap(missing)).toEqual([])
  })
}

/**
 * Constants of a module in capitals whose comment, or whose section's heading, cites no record that names
 * them.
 */
function unexplained(path: string) {
  let heading = ''
  let comment = ''
  const names: string[] = []
  for (const line of read(path).split('\n')) {
    if (line.startsWith('// ')) heading = line
    else if (/^(\/\*\*| \*)/.test(line)) comment = line.startsWith('/**') ? line : comment + line
    const name = line.match(/^(?:export )?const ([A-Z][A-Z_]+) = [-\d]/)?.[1]
    if (!name) continue
    const cited = (heading + comment).match(/D-0\d\d/g) ?? []
    if (!cited.some((id) => records.get(id)?.includes(`\`${name}\``))) names.push(name)
  }
  return names
}

test('every number of the solver cites a record that names it', () => {
  expect(unexplained('registry/gravity-stack/solver/constants.ts')).toEqual([])
})

test('every number of the stage cites a record that names it', () => {
  const modules = paths.filter((path) => /gravity-stack\/stage\/[\w-]+\.ts$/.test(path))
  expect(modules.length).toBeGreaterThan(10)
  expect(modules.flatMap(unexplained)).toEqual([])
})

const architecture = read('ARCHITECTURE.md')
const answers = [
  ...architecture.split('## Where does X happen')[1].matchAll(/^\| (?!-|question)(.+?) +\| (.+?) +\|$/gm),
]

test('comments fit in 110 columns', () => {
  const written = [...sources].filter(([path]) => /\.(tsx?|mjs)$/.test(path))
  const wide = written.flatMap(([path, text]) =>
    text
      .split('\n')
      .flatMap((line, n) =>
        line.length > 110 && /^ *(\/\/|\*|\/\*)/.test(line) ? [`${path}:${n + 1}`] : [],
      ),
  )
  expect(wide).toEqual([])
})

test('ARCHITECTURE.md is short', () => {
  expect(answers.length).toBeGreaterThan(8)
  expect(architecture.split('\n').length).toBeLessThanOrEqual(150)
})

for (const [, question, answer] of answers) {
  test(`ARCHITECTURE.md says where to look in at most two files: ${question}`, () => {
    const folder = answer.match(/(solver|stage)\//)?.[0] ?? ''
    const [files, names] = [/\.tsx?$/, /^[\w.]+(?<!\.tsx?)$/].map((kind) =>
      quoted(answer).filter((text) => kind.test(text)),
    )
    expect(files.length).toBeGreaterThan(0)
    expect(files.length).toBeLessThanOrEqual(2)
    const texts = files.map((file) => {
      const path = `registry/gravity-stack/${file}`
      return sources.get(path) ?? sources.get(`registry/gravity-stack/${folder}${file}`) ?? `no ${file}`
    })
    expect(texts.filter((text) => text.startsWith('no '))).toEqual([])
    expect(names.filter((name) => !texts.some((text) => text.includes(name)))).toEqual([])
  })
}

test('CONTRIBUTING.md names every file of figures, and commands that exist', () => {
  const contributing = read('CONTRIBUTING.md')
  const kept = [
    ...readdirSync(join(root, 'bench/results')),
    ...paths.filter((path) => /(bounds|accepted|found|pins)\.json$/.test(path)),
  ]
  expect(kept.filter((name) => !contributing.includes(name))).toEqual([])
  const commands = quoted(contributing).filter((text) => /^(npm run|npx tsx) /.test(text))
  expect(commands.flatMap((command) => missing(command.split(' && ')[0]))).toEqual([])
})
