import 'server-only'
import { ours } from '@/bench/publish/report'
import { blocks } from './blocks'
import { browserResults, dropOf } from './evidence/browser'
import { costRow, results } from './evidence/results'
import { capital, inWords } from './evidence/words'
import { componentSize } from './size'

/** A processor's name as a page says it. */
const plain = (cpu: string) => cpu.replaceAll('(R)', '')

/** µs that the solver takes for a frame of 60 awake chips, as the benchmark has it. */
const micros = Math.round(costRow(ours, 60)!.cost!.mean)

// What the home page says, for the page and its Markdown alike.
export const pitch = {
  title: 'Words with weight',
  lead: 'A React component whose children drop in, tumble and settle into a pile. Its own rigid-body solver, in the one file you copy.',
}

/** What it costs, short enough for the first screen: a figure and what it is of. */
export async function price(): Promise<[figure: string, of: string][]> {
  return [
    [`${await componentSize()} kB`, 'not counting React and cn'],
    [`${micros} µs`, 'of physics a frame, 60 chips'],
    ['0 frames', 'at rest'],
  ]
}

export type Fact = { figure: string; title: string; text: string; more?: { title: string; href: string } }

export async function facts(): Promise<Fact[]> {
  const { script } = dropOf(browserResults.stages[ours], 60, 1)!
  return [
    {
      figure: `${await componentSize()} kB`,
      title: 'the whole component',
      text: 'Minified and compressed, with the solver and the part of Motion that it uses, not counting React and cn.',
    },
    {
      figure: '1',
      title: 'file, yours once copied',
      text: 'It reads as if you had written it: a section for each job, every number with its unit and its reason.',
    },
    {
      figure: '0',
      title: 'frames at rest',
      text: 'Chips that lie still sleep, and the loop ends with the last of them. Off screen nothing runs at all.',
    },
    {
      figure: `${micros} µs`,
      title: 'of physics a frame, 60 chips awake',
      text: `The solver alone, in Node on ${plain(results.machine.cpu)}; with the page around it ${script.median.toFixed(1)} ms of script, in Chromium on ${plain(browserResults.machine.cpu)}. Beside six other engines and against exact answers.`,
      more: { title: 'Benchmarks', href: '/benchmarks' },
    },
  ]
}

/**
 * What the latest version brought, for the home page and its Markdown: the first is shown, the others are
 * told.
 */
export const news = {
  title: 'Words land the right way up',
  text: 'A copy of the pile goes ahead and tells how each chip will lie. The chip then starts turned, so that its word ends upright. The pile is the same pile: flip it and watch the outlines.',
  more: { title: 'How it works', href: '/docs/how-it-works' },
  others: [
    {
      title: 'Obstacles, and a direction',
      href: '/docs/gravity-stack#shelves',
      text: 'Chips land on your headings and buttons and go round them. Gravity points wherever you say, a ceiling closes the top, and a mouse may push.',
    },
    {
      title: 'A pile as a link',
      href: '/playground',
      text: 'The playground copies what you did as an address. It plays step for step, to the same bits, in every browser.',
    },
    {
      title: 'A light that stays above',
      href: '/docs/elevation',
      text: 'Each chip at rest tells its angle. A shadow falls down the screen, however the chip lies.',
    },
    {
      title: `${capital(inWords(blocks.length))} blocks`,
      href: '/blocks',
      text: 'Hero to footer: parts of a page, each one file, taken with one command.',
    },
  ],
}

export const ways = [
  {
    title: 'Playground',
    href: '/playground',
    text: 'Tune what shapes the fall, step through it, take the code.',
  },
  {
    title: 'How it works',
    href: '/docs/how-it-works',
    text: 'Seven ideas, each with a figure that runs the solver under your fingers.',
  },
  {
    title: 'Accessibility',
    href: '/docs/accessibility',
    text: 'Reduced motion, keyboard, screen reader, touch, paper: criterion by criterion.',
  },
]
