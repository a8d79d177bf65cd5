import { chromium, expect, test } from '@playwright/test'
import lighthouse, { type Result } from 'lighthouse'
import { findBrowser } from '../scripts/browser.mjs'
import { freePort } from './free-port'

// Lighthouse as it comes: a phone on a slow network, simulated. Its performance score hangs on how busy this
// machine is, so it is printed; what decides it on an idle one is held here: bytes, requests that block,
// shifts.
const pages = [
  { path: '/', kilobytes: 270 },
  { path: '/docs/gravity-stack', kilobytes: 290 },
  { path: '/blocks', kilobytes: 300 },
  { path: '/benchmarks', kilobytes: 330 },
]

type Row = Record<string, unknown>
const rows = (lhr: Result, audit: string) =>
  ((lhr.audits[audit].details as { items?: Row[] } | undefined)?.items ?? []) as Row[]

for (const { path, kilobytes } of pages) {
  test(`on a phone, ${path} is accessible, sound, findable and light, says Lighthouse`, async ({
    baseURL,
  }) => {
    const port = await freePort()
    const browser = await chromium.launch({
      executablePath: findBrowser()?.path,
      args: [`--remote-debugging-port=${port}`],
    })
    try {
      const { lhr } = (await lighthouse(`${baseURL}${path}`, {
        port,
        logLevel: 'error',
        disableFullPageScreenshot: true,
      }))!
      const points = (category: string) => Math.round(lhr.categories[category].score! * 100)
      const score = `Lighthouse, ${path}: performance ${points('performance')}, blocked ${lhr.audits['total-blocking-time'].displayValue}, largest paint ${lhr.audits['largest-contentful-paint'].displayValue}`
      console.log(score)
      test.info().annotations.push({ type: 'score', description: score })

      const lost = ['accessibility', 'best-practices', 'seo'].flatMap((category) =>
        lhr.categories[category].auditRefs
          .map(({ id }) => lhr.audits[id])
          .filter((audit) => audit.score !== null && audit.score < 1 && audit.scoreDisplayMode === 'binary')
          .map((audit) => `${category}: ${audit.title}`),
      )
      expect(lost).toEqual([])
      for (const category of ['accessibility', 'best-practices', 'seo']) {
        expect(points(category), category).toBe(100)
      }
      const shifts = JSON.stringify(rows(lhr, 'layout-shifts'))
      expect(lhr.audits['cumulative-layout-shift'].numericValue, shifts).toBe(0)
      // Stylesheets alone may hold up the first paint.
      const blocking = rows(lhr, 'render-blocking-resources').map(({ url }) => String(url))
      expect(blocking.filter((url) => !url.endsWith('.css'))).toEqual([])
      expect(lhr.audits['total-byte-weight'].numericValue! / 1000).toBeLessThanOrEqual(kilobytes)
      const asked = rows(lhr, 'network-requests').map(({ url }) => String(url))
      // The loader of late scripts has an empty script of its own.
      const strangers = asked.filter((url) => !url.startsWith(baseURL!) && url !== 'data:text/javascript,')
      expect(strangers).toEqual([])
    } finally {
      await browser.close()
    }
  })
}
