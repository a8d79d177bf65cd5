// Makes the pictures of README and of links to the site, from the component on the built home page:
//   npm run build && node scripts/pictures.mjs
// public/opengraph-image.png is the pile at rest, public/opengraph-loop.webp the drop before it.
// .github/pile-*.png is the pile alone in both themes.
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { chromium } from '@playwright/test'
import { siteUrl } from '../site.config.mjs'
import { findBrowser } from './browser.mjs'
import { root } from './run.mjs'
import { serveSite } from './serve.mjs'

// The image library that Next brings.
const sharp = createRequire(createRequire(import.meta.url).resolve('next/package.json'))('sharp')

const size = { width: 1200, height: 630 }
/** ms between two pictures of the loop, and for how long the pile is shown at rest. */
const interval = 60
const rest = 2400
const longest = 12_000

/** The hero alone, as large as the picture. */
const alone = `
  header, main > :not(:first-child), main ul, h1 ~ div { display: none !important }
  main > :first-child section { position: fixed !important; inset: 0; z-index: 9999 }`
const pileAlone = `${alone}
  main > :first-child section > :first-child { visibility: hidden }
  [data-slot=gravity-stack-chip] > * { font-size: 1.1rem !important; padding: 0.6rem 1.2rem !important }`
const poster = `${alone}
  main > :first-child section > div:first-child { padding-top: 3.25rem !important; min-height: 0 !important }
  h1::before { content: 'Gravity Stack'; display: block; margin-bottom: 1.1rem; font-size: 1.9rem; font-weight: 500;
    letter-spacing: -0.01em; opacity: 0.6 }
  h1 { font-size: 6.6rem !important; line-height: 1.05 !important }
  h1 + p { font-size: 1.6rem !important; max-width: 47rem !important; margin-top: 1.6rem !important }
  [data-slot=gravity-stack-chip] > * { font-size: 1.42rem !important; padding: 0.85rem 1.5rem !important }`

await serveSite()
const browser = await chromium.launch({ executablePath: findBrowser()?.path })

/**
 * The home page with these styles and its pile dropped anew, in which time passes only when it is told to.
 */
async function open(css, options) {
  const page = await browser.newPage(options)
  // Picture by picture: a busy machine makes the same loop as an idle one.
  await page.clock.install({ time: 0 })
  await page.addInitScript(() => {
    Object.defineProperty(document, 'timeline', { get: () => ({ currentTime: performance.now() }) })
  })
  await page.goto(siteUrl)
  await page.addStyleTag({ content: css })
  await page.evaluate(() => document.fonts.ready)
  await page.clock.pauseAt(20_000)
  const stage = page.locator('[data-slot=gravity-stack]').first()
  const isResting = async () => (await stage.getAttribute('data-state')) === 'resting'
  // The drop of the chips as the styles have made them.
  await page.evaluate(() =>
    [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Drop again').click(),
  )
  return { page, isResting }
}

for (const colorScheme of ['light', 'dark']) {
  const viewport = { width: 850, height: 259 }
  const { page, isResting } = await open(pileAlone, { viewport, colorScheme, deviceScaleFactor: 2 })
  for (let time = 0; time < longest; time += 250) {
    await page.clock.runFor(250)
    if (await isResting()) break
  }
  const picture = sharp(await page.screenshot()).png({ palette: true, quality: 100, effort: 10 })
  await picture.toFile(join(root, `.github/pile-${colorScheme}.png`))
  await page.close()
}

const { page, isResting } = await open(poster, { viewport: size })
const frames = []
for (let time = 0; time < longest; time += interval) {
  await page.clock.runFor(interval)
  frames.push(await page.screenshot())
  if (await isResting()) break
}
const last = frames.at(-1)
await sharp(last)
  .png({ palette: true, quality: 100, effort: 10 })
  .toFile(join(root, 'public/opengraph-image.png'))
const small = await Promise.all(
  frames.map((frame) =>
    sharp(frame)
      .resize(size.width / 2)
      .png()
      .toBuffer(),
  ),
)
const delay = small.map((_, i) => (i === small.length - 1 ? rest : interval))
await sharp(small, { join: { animated: true } })
  .webp({ loop: 0, delay, quality: 80, effort: 4 })
  .toFile(join(root, 'public/opengraph-loop.webp'))
console.log(`${frames.length} pictures of the loop; at rest in the last: ${await isResting()}`)
await browser.close()
process.exit(0)
