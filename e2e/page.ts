import { readdirSync } from 'node:fs'
import { test as base, type Page } from '@playwright/test'

/** Addresses of the docs, and of all pages of the site. */
export const docs = readdirSync('content/docs').map((file) => `/docs/${file.replace('.mdx', '')}`)
export const pages = ['/', '/docs', '/blocks', '/playground', '/benchmarks', ...docs, '/404']

export const playgroundStage = '[data-slot=playground-stage]'

/**
 * Pages ask for their script when they have been painted, which `load` doesn't wait for: until React has the
 * page, down to its last part. It begins as soon as some of its scripts are there, and a press before the
 * others have come is lost.
 */
export const alive = (page: Page) =>
  page.waitForFunction(() =>
    Object.keys(document.documentElement).some((key) => key.startsWith('__reactProps')),
  )

/** Until what was asked for so far has been painted. */
export const painted = (page: Page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))))

/** Holds back the scripts of a page until what it returns is called. */
export async function withhold(page: Page, scripts: string) {
  let letCome = () => {}
  const called = new Promise<void>((resolve) => {
    letCome = resolve
  })
  await page.route(scripts, async (route) => {
    await called
    await route.continue()
  })
  return letCome
}

/** With pages that answer to a press as soon as `goto` and `reload` come back. */
export const test = base.extend({
  page: async ({ page, javaScriptEnabled }, use) => {
    if (javaScriptEnabled !== false) {
      const { goto, reload } = page
      page.goto = async (...args) => {
        const answer = await goto.apply(page, args)
        await alive(page)
        return answer
      }
      page.reload = async (...args) => {
        const answer = await reload.apply(page, args)
        await alive(page)
        return answer
      }
    }
    await use(page)
  },
})

/** Call before a page loads. Returns how far its content has shifted since, by the browser's own measure. */
export async function watchShifts(page: Page) {
  await page.addInitScript(() => {
    let shifted = 0
    const add = (entries: PerformanceEntryList) => {
      for (const entry of entries) shifted += (entry as PerformanceEntry & { value: number }).value
    }
    const observer = new PerformanceObserver((list) => add(list.getEntries()))
    observer.observe({ type: 'layout-shift', buffered: true })
    Object.assign(window, {
      shifted() {
        add(observer.takeRecords())
        return shifted
      },
    })
  })
  return () => page.evaluate<number>('shifted()')
}
