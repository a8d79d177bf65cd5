import 'server-only'
import type { Doc } from 'contentlayer/generated'
import { ours } from '@/bench/publish/report'
import { siteUrl, version } from '@/site.config.mjs'
import { blocks, blocksPitch } from './blocks'
import { docs, navigation } from './docs'
import { browserHead, browserRows, chipCounts, chipCountsHead } from './evidence/browser'
import { engineOrder, looks } from './evidence/engines'
import { claim, costRow, results, sizes } from './evidence/results'
import { cellsOf, fuzzHead, fuzzRows, hardRows, knownRows, slideWords } from './evidence/scenes'
import { verdictHead, verdictWords } from './evidence/words'
import { figure } from './figure'
import { heroCode } from './hero-code'
import { facts, news, pitch, ways } from './home'
import { looks as chipLooks, codeOf, defaults, ranges, shapes } from './playground'
import { promptOf } from './prompt'
import { readActions, readProps } from './props'
import { blockSource, changelog, elevationSource, exampleSource } from './source'

const fence = (lang: string, code: string, title?: string) =>
  `\`\`\`${lang}${title ? ` title="${title}"` : ''}\n${code.trimEnd()}\n\`\`\``

/** A table; a bar in a cell would end it. */
function table(head: string[], rows: string[][]) {
  const line = (cells: string[]) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n')
}

const scenesTable = (bound: string, scenes: ReturnType<typeof hardRows>) =>
  table(
    ['Scene', 'Measure', 'Figure', bound],
    scenes.flatMap(({ title, rows }) =>
      rows.map((row) => {
        const cells = cellsOf(row)
        return [title, row.measure, cells.figure, cells.missed ? `${cells.bound}, missed` : cells.bound]
      }),
    ),
  )

const add = (name: string) => fence('bash', `npx shadcn@latest add ${siteUrl}/r/${name}.json`)

/** What each component of a page becomes in Markdown; '' for what only a browser can show. */
const parts: Record<string, (attributes: Record<string, string>) => string> = {
  ActionsTable: () =>
    table(
      ['Action', 'What it does'],
      readActions().map(({ name, description }) => [`\`${name}()\``, description]),
    ),
  AddNamespace: () => fence('bash', `npx shadcn@latest registry add @liten=${siteUrl}/r/{name}.json`),
  PinVersion: () =>
    fence('bash', `npx shadcn@latest registry add @liten=${siteUrl}/r/${version}/{name}.json`),
  AddCommand: ({ name }) => add(name),
  Changelog: changelog,
  Command: ({ add, run }) => fence('bash', add ? `npm install ${add}` : `npx ${run}`),
  ComponentPreview: ({ name }) => fence('tsx', exampleSource(name), `${name}.tsx`),
  ComponentSource: () => `The whole file: ${siteUrl}/source/gravity-stack.tsx.txt`,
  ElevationLadder: () => '',
  ElevationSource: () => fence('css', elevationSource()),
  Install: () => '',
  LiveFigure: () => '_On the page itself a figure runs here._',
  InstallWay: ({ of }) =>
    of === 'cli' ? 'With the CLI:' : of === 'manual' ? 'By hand:' : 'By a coding assistant:',
  Prompt: ({ name }) => fence('md', promptOf(name)),
  ChipCounts: () =>
    table(
      chipCountsHead,
      chipCounts().map((row) => [...row]),
    ),
  SlideWords: slideWords,
  FuzzTable: () =>
    table(
      fuzzHead,
      fuzzRows().map((row) => row.map(String)),
    ),
  HardScenesTable: () => scenesTable('Bound', hardRows()),
  ScenesTable: () => scenesTable('Target', knownRows()),
  PropsTable: () =>
    table(
      ['Prop', 'Type', 'Default', 'What it does'],
      readProps().map((prop) => [
        `\`${prop.name}\``,
        `\`${prop.type}\`${prop.range ? `, ${prop.range}` : ''}`,
        prop.fallback ? `\`${prop.fallback}\`` : '–',
        prop.description,
      ]),
    ),
}

/** A page of the docs as plain Markdown. Throws on a component that `parts` doesn't know. */
function docMarkdown(doc: Doc): string {
  const blocks = doc.body.raw.split(/(^```[\s\S]*?^```$)/m).map((block) => {
    if (block.startsWith('```')) return block
    return block
      .replace(/^<([A-Z]\w*)([^>]*?)\/?>$/gm, (_, name: string, text: string) => {
        const part = parts[name]
        if (!part) throw new Error(`lib/markdown.ts has no Markdown for <${name}>, used in ${doc.slug}.mdx`)
        return part(
          Object.fromEntries([...text.matchAll(/(\w+)="([^"]*)"/g)].map(([, key, value]) => [key, value])),
        )
      })
      .replace(/^<\/[A-Z]\w*>$/gm, '')
      .replace(
        /\]\(\/docs\/([\w-]+)(#[^)]*)?\)/g,
        (_, slug, hash = '') => `](${siteUrl}/docs/${slug}.md${hash})`,
      )
      .replace(/\]\(\//g, `](${siteUrl}/`)
  })
  const body = blocks
    .join('')
    .replace(/\n{3,}/g, '\n\n')
    .trim()
  return `# ${doc.title}\n\n> ${doc.description}\n\n${body}\n`
}

const page = (title: string, description: string, ...blocks: string[]) =>
  `${[`# ${title}`, `> ${description}`, ...blocks].join('\n\n')}\n`

/** The twin of a page of ours, which has the same address with .md behind it. */
const twinOf = (href: string) => `${siteUrl}${href.replace(/(?=#|$)/, '.md')}`

const home = async () =>
  page(
    pitch.title,
    pitch.lead,
    add('gravity-stack'),
    (await facts()).map(({ figure, title, text }) => `- **${figure}** ${title}. ${text}`).join('\n'),
    `## New in ${version}`,
    `**${news.title}.** ${news.text}`,
    news.others.map(({ title, href, text }) => `- [${title}](${twinOf(href)}): ${text}`).join('\n'),
    '## In code',
    fence('tsx', heroCode({ neutral: false, heavier: false, bouncier: false })),
    'With neutral surfaces, more gravity, more bounce, and a button:',
    fence('tsx', heroCode({ neutral: true, heavier: true, bouncier: true }, 'drop')),
    '## On from here',
    [...ways, { title: 'Docs', href: '/docs', text: 'All pages.' }]
      .map(({ title, href, text }) => `- [${title}](${twinOf(href)}): ${text}`)
      .join('\n'),
  )

const index = () =>
  page(
    'Docs',
    'Everything about the component: how to install it, how it works, and what has been measured.',
    ...navigation.flatMap(({ title, pages }) => [
      `## ${title}`,
      pages.map((at) => `- [${at.title}](${twinOf(at.href)}): ${at.description}`).join('\n'),
    ]),
  )

const blocksPage = () =>
  page(
    blocksPitch.title,
    blocksPitch.lead,
    ...blocks.flatMap(({ name, title, description }) => [
      `## ${title}`,
      description,
      add(name),
      fence('tsx', blockSource(name), `${name}.tsx`),
    ]),
  )

const playground = () =>
  page(
    'Playground',
    'Tune the props, watch the contacts, take the code.',
    `The address holds the settings: ${siteUrl}/playground?shape=mixed&gravity=1200. What it leaves out is at its default. \`seed\` is the playground's own: the component has no such prop, and the code leaves it out. What follows \`#pile=\` is a pile that was recorded there: the page plays it again, step for step, and so does \`npx tsx bench/replay.ts LINK\` in a clone.`,
    table(
      ['In the address', 'Values', 'Default'],
      Object.entries(defaults).map(([name, value]) => {
        const range = ranges[name as keyof typeof ranges]
        const values =
          { shape: shapes.join(', '), look: chipLooks.join(', '), words: 'words with commas between' }[
            name
          ] ?? (range ? `${range[0]} to ${range[1]}` : 'true, false')
        return [`\`${name}\``, values, String(value)]
      }),
    ),
    'Untouched, it makes this:',
    fence('tsx', codeOf(defaults)),
  )

const benchmarks = () =>
  page(
    'Run time against error',
    'Run time against error for Gravity Stack beside six other engines, scene by scene.',
    `Measured on ${results.machine.cpu}, Node ${results.machine.node}. Raw data: ${siteUrl}/benchmarks/results.json, ${siteUrl}/benchmarks/errors.csv, ${siteUrl}/benchmarks/costs.csv. The plots are on the page: ${siteUrl}/benchmarks`,
    table(
      verdictHead,
      claim.map((verdict) => {
        const { scene, measure } = verdict
        const { error, cost, asCheap, asExact, frontier } = verdictWords(verdict)
        return [`${scene.title}: ${scene.measures[measure].name}`, error, cost, asCheap, asExact, frontier]
      }),
    ),
    '## What a frame costs',
    'µs in the mean of four seconds, of which the first 1.5 s are fall and landing; no chip sleeps.',
    table(
      ['Engine', ...sizes.map((size) => `${size} chips`)],
      engineOrder.map((engine) => [
        looks[engine].title,
        ...sizes.map((size) => {
          const row = costRow(engine, size)
          if (row?.cost) return figure(row.cost.mean)
          return row?.atLeast ? `> ${figure(row.atLeast)}` : '–'
        }),
      ]),
    ),
    '## What a page has to load',
    table(
      ['What', 'kB, gzipped'],
      results.bytes.map(({ name, gzip }) => [
        name === ours
          ? 'Gravity Stack, the solver alone'
          : (looks[name]?.title ?? 'Gravity Stack, the whole component'),
        (gzip / 1000).toFixed(1),
      ]),
    ),
    '## In a browser',
    table(
      browserHead,
      browserRows.map(({ name, goal, figures }) => [
        name,
        goal,
        ...figures.map(({ text, missed }) => (missed ? `${text}, goal missed` : text)),
      ]),
    ),
    `“Circle chains” is the method of this component’s first design, written afresh for this comparison. How all of this was measured, and what to know before you believe it: ${siteUrl}/benchmarks#fair`,
  )

/** Every page as Markdown, by the path of its twin. */
export const twins: Record<string, () => string | Promise<string>> = {
  'index.md': home,
  'docs.md': index,
  'blocks.md': blocksPage,
  'playground.md': playground,
  'benchmarks.md': benchmarks,
  ...Object.fromEntries(docs.map((doc) => [`docs/${doc.slug}.md`, () => docMarkdown(doc)])),
}
