import { dearer, lost } from '@/lib/evidence/results'
import type { Heading } from '@/lib/headings'

export const groups: { id: string; title: string; text: string; scenes: RegExp }[] = [
  {
    id: 'flight',
    title: 'Flight',
    text: 'The answer is a formula, so the error is the distance from it after a second.',
    scenes: /^(free-fall|projectile|spin)/,
  },
  {
    id: 'bounces',
    title: 'Bounces and impacts',
    text: 'Heights, paths and velocities follow from Newton’s restitution and Coulomb’s friction at the moment of impact.',
    scenes: /^(bounce|pill-impact|oblique|ricochet)/,
  },
  {
    id: 'friction',
    title: 'Friction',
    text: 'Three questions: where a box stops, where a disc begins to roll, and how a pill topples over its own round end.',
    scenes: /^(slide|roll|topple)/,
  },
  {
    id: 'stacks',
    title: 'Stacks',
    text: 'What stands should stand: the error is how far the furthest corner has moved.',
    scenes: /^(stack|pyramid|mass-ratio)/,
  },
  {
    id: 'pours',
    title: 'Pours',
    text: 'A pile is chaotic, so no pose of it is right or wrong. The error is how deep chips sink into each other.',
    scenes: /^pour/,
  },
]

export const headings: Heading[] = [
  { depth: 2, id: 'claim', text: 'The claim, scene by scene' },
  ...(lost.length > 0 ? [{ depth: 3, id: 'exceptions', text: 'The exceptions' }] : []),
  { depth: 2, id: 'plots', text: 'Work and precision' },
  ...groups.map(({ id, title }) => ({ depth: 3, id, text: title })),
  { depth: 2, id: 'order', text: 'More sub-steps, less error' },
  { depth: 2, id: 'pour', text: 'Sixty pills, all properties' },
  { depth: 2, id: 'chips', text: 'Cost by number of chips' },
  { depth: 3, id: 'cheaper', text: 'Who is cheaper' },
  { depth: 3, id: 'frames', text: 'Sixty pills, frame by frame' },
  { depth: 2, id: 'weight', text: 'What a page has to load' },
  { depth: 2, id: 'browser', text: 'In a browser' },
  { depth: 2, id: 'device', text: 'On your device' },
  { depth: 2, id: 'fair', text: 'What to know before you believe it' },
  { depth: 3, id: 'seeds', text: 'Seeds of the pours' },
  ...(dearer.length > 0 ? [{ depth: 3, id: 'unmarked', text: 'Settings without a mark' }] : []),
]
