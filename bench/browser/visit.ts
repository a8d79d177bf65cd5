// Opens a page that is measured, and waits for its marks. An import starts the browser and the server.
import { type Browser, type BrowserContext, type CDPSession, chromium, type Page } from '@playwright/test'
import { pourStage } from '../../scenes/piles'
import { bringBrowser } from '../../scripts/browser.mjs'
import type { Look } from './chips'
import type { StageName } from './results'
import { serve } from './serve'

/** The one stage that comes to rest. */
export const restful: StageName = 'gravity-stack'
/** s that a stage which never rests is watched after its last release. */
export const watched = 2

await bringBrowser()
export const server = await serve()
export const launch = () => chromium.launch({ executablePath: process.env.CHROME_PATH })

type Visit = {
  stage: StageName | 'demos'
  chips: number
  stagger: number
  throttle?: number
  above?: number
  /** px, where not what so many chips fill. */
  width?: number
  look?: Look
}

export const wait = (seconds: number) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds))

/** A fresh page as the server sends it, its script not yet loaded. */
export async function visit<T>(
  browser: Browser,
  { stage, chips, stagger, throttle = 1, above = 0, look = 'pills', ...more }: Visit,
  extra: { counting?: boolean; recording?: boolean; restless?: boolean; upright?: boolean },
  work: (page: Page, session: CDPSession, start: () => Promise<unknown>) => Promise<T>,
): Promise<T> {
  let context: BrowserContext | undefined
  try {
    context = await browser.newContext({ viewport: { width: 2700, height: 1500 } })
    const page = await context.newPage()
    const marks = new Set<string>()
    told.set(page, marks)
    page.on('console', (message) => marks.add(message.text()))
    const failed = new Promise<never>((_, reject) => page.on('pageerror', reject))
    failed.catch(() => {})
    const { width, height } = { ...pourStage(chips), ...more }
    const { counting = false, recording = false, restless = false, upright = true } = extra
    const query = {
      chips,
      stagger,
      width,
      height,
      above,
      counting,
      recording,
      restless,
      upright,
      look: JSON.stringify(look),
    }
    await page.goto(`${server.url}/${stage}?${new URLSearchParams(query as never)}`)
    const session = await context.newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: throttle })
    const start = () => page.addScriptTag({ type: 'module', url: `${server.url}/${stage}/client.js` })
    return await Promise.race([work(page, session, start), failed])
  } finally {
    // One that failed may have left it running, and no other could begin.
    await browser.stopTracing().catch(() => {})
    await context?.close()
  }
}

/** The marks that each page has told of. */
const told = new WeakMap<Page, Set<string>>()

/**
 * Waits until the page has set this mark. The page is asked nothing: an answer would cost measured frames.
 */
export async function marked(page: Page, name: string, seconds = 60) {
  const end = performance.now() + 1000 * seconds
  while (!told.get(page)?.has(name)) {
    if (performance.now() > end) throw new Error(`${page.url()} has not told of ${name} for ${seconds} s`)
    await wait(0.05)
  }
}

/** Until the stage rests; one that never does is left when it would long have. */
export async function dropped(page: Page, { stage, chips, stagger }: Visit) {
  await marked(page, 'drawn')
  if (stage !== 'circle-chains' && stage !== 'matter-js') await marked(page, 'rest')
  else await wait((chips * stagger) / 1000 + watched)
}
