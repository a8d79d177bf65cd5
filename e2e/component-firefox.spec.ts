import { test as base, expect } from '@playwright/test'
import { type Browser, launch, type Page } from 'puppeteer-core'
import { worstOverlap } from '../scenes/exact-distance'
import { findEngines } from '../scripts/browser.mjs'
import { installProbe } from './fixtures/probe'
import { growth, readBar, readOutside, readPile, scrolled } from './fixtures/stage'

// A Firefox as people have it, by WebDriver BiDi. Playwright asks one for media features that it can't feign,
// and gets no page.

const executablePath = findEngines().find(({ name }) => name === 'Firefox')?.path

const STAGE = '[data-slot=gravity-stack]'

const test = base.extend<{ firefoxPrefs: Record<string, unknown>; firefox: Page }>({
  firefoxPrefs: [{}, { option: true }],
  firefox: async ({ firefoxPrefs }, use) => {
    const browser: Browser = await launch({
      browser: 'firefox',
      executablePath,
      extraPrefsFirefox: firefoxPrefs,
    })
    try {
      const page = await browser.newPage()
      page.setDefaultTimeout(60_000)
      await page.setViewport({ width: 1280, height: 720 })
      await page.evaluateOnNewDocument(installProbe)
      await use(page)
      expect(await page.evaluate(() => window.probe.errors)).toEqual([])
    } finally {
      await browser.close()
    }
  },
})

const reaches = (page: Page, state: string) => page.waitForSelector(`${STAGE}[data-state=${state}]`)
const chip = (n: number) => `${STAGE} > :nth-child(${n})`
const stateOf = (page: Page, selector: string) =>
  page.$eval(selector, (element) => element.getAttribute('data-state'))
const centreOf = (page: Page, selector: string) =>
  page.$eval(selector, (element) => {
    const { x, y, width, height } = element.getBoundingClientRect()
    return { x: x + width / 2, y: y + height / 2 }
  })

async function overlap(page: Page) {
  const { shapes, poses, stage } = await page.$eval(STAGE, readPile)
  return worstOverlap(shapes, poses, stage)
}

// Where there is none the totals say so.
if (executablePath) {
  test('in Firefox chips fall, lie still and apart, can be carried, and no frame runs at rest', async ({
    firefox: page,
    baseURL,
  }) => {
    await page.goto(`${baseURL}/pile?chips=12&shape=all&stagger=40`)
    await reaches(page, 'resting')
    expect(await overlap(page)).toBeLessThan(1)

    const from = await centreOf(page, chip(3))
    await page.mouse.move(from.x, from.y)
    await page.mouse.down()
    await reaches(page, 'running')
    expect(await stateOf(page, chip(3))).toBe('held')
    await page.mouse.move(320, 100, { steps: 10 })
    const lag = async () => {
      const at = await centreOf(page, chip(3))
      return Math.hypot(at.x - 320, at.y - 100)
    }
    await expect.poll(lag).toBeLessThan(30)
    await page.mouse.up()
    expect(await stateOf(page, chip(3))).toBe('falling')

    await reaches(page, 'resting')
    expect(await overlap(page)).toBeLessThan(1)
    expect(await page.evaluate(growth)).toBe(0)
  })

  test('in Firefox what reaches out of a full stage is cut off', async ({ firefox: page, baseURL }) => {
    await page.goto(`${baseURL}/pile?chips=60&stagger=20&above=200&box=h-40%20w-64`)
    await reaches(page, 'resting')
    const { chips, pressed } = await page.$eval(STAGE, readOutside)
    expect(chips).toBeGreaterThan(3)
    expect(pressed).toBe(0)
  })

  test('in Firefox nothing in a stage scrolls, though its style says "overflow: hidden"', async ({
    firefox: page,
    baseURL,
  }) => {
    await page.goto(`${baseURL}/pile?chips=3`)
    await reaches(page, 'resting')
    await page.$eval(STAGE, (stage) => stage.setAttribute('style', 'overflow: hidden'))
    expect(await page.$eval(STAGE, scrolled)).toBe(0)
  })

  test('in Firefox chips drop when a link to the text of one leads to the stage, in a window 360 px high', async ({
    firefox: page,
    baseURL,
  }) => {
    await page.setViewport({ width: 800, height: 360 })
    await page.goto(`${baseURL}/pile?stagger=40&above=900&below=900#:~:text=springs`)
    await reaches(page, 'resting')
  })

  test('in Firefox a drag on a link does not follow it; the key after a drag that no click follows does', async ({
    firefox: page,
    baseURL,
  }) => {
    await page.goto(`${baseURL}/controls?stagger=40`)
    await reaches(page, 'resting')
    const { x, y } = await centreOf(page, '[data-name=link]')
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x, y - 60, { steps: 5 })
    expect(await stateOf(page, chip(1))).toBe('held')
    // The browser takes the pointer away: what comes next is no click of this drag.
    await page.$eval(chip(1), (element) => {
      window.dispatchEvent(new PointerEvent('pointercancel', { pointerId: 0 }))
      element.querySelector('a')?.focus()
    })
    expect(new URL(page.url()).hash).toBe('')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => location.hash === '#link')
    await page.mouse.up()
  })

  test.describe('in Firefox with bars that take room', () => {
    test.use({ firefoxPrefs: { 'widget.gtk.overlay-scrollbars.enabled': false } })

    test('the scroll bar of a card scrolls the card, which is not held meanwhile', async ({
      firefox: page,
      baseURL,
    }) => {
      await page.goto(`${baseURL}/surroundings?kind=card`)
      await reaches(page, 'resting')
      const card = `${chip(1)} > div`
      const [from, to] = await page.$eval(card, readBar)
      await page.mouse.move(from.x, from.y)
      await page.mouse.down()
      await page.mouse.move(to.x, to.y, { steps: 5 })
      await expect.poll(() => page.$eval(card, (element) => element.scrollTop)).toBeGreaterThan(30)
      expect(await stateOf(page, chip(1))).toBe('resting')
      await page.mouse.up()
    })
  })

  test.describe('in Firefox with reduced motion', () => {
    test.use({ firefoxPrefs: { 'ui.prefersReducedMotion': 1 } })

    test('the chips stand in a row, and nothing moves', async ({ firefox: page, baseURL }) => {
      await page.goto(`${baseURL}/pile?chips=4`)
      await page.evaluate(() => window.probe.pass(20))
      expect(await stateOf(page, STAGE)).toBe('static')
      expect(await page.evaluate(() => window.probe.frames)).toBe(0)
      const { shapes, poses } = await page.$eval(STAGE, readPile)
      expect(poses.map(({ x, y }, i) => [x - shapes[i].width / 2, y - shapes[i].height / 2])).toEqual(
        poses.map(() => [0, 0]),
      )
      const tops = await page.$$eval(`${STAGE} > *`, (all) => all.map((one) => one.getBoundingClientRect().y))
      expect(new Set(tops).size).toBe(1)
    })

    test('words can be selected in the row', async ({ firefox: page, baseURL }) => {
      await page.goto(`${baseURL}/pile?chips=4`)
      const { x, y } = await centreOf(page, chip(1))
      await page.mouse.click(x, y, { count: 2 })
      expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe('design')
    })
  })
}
