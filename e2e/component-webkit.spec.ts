import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test as base, expect } from '@playwright/test'
import { worstOverlap } from '../scenes/exact-distance'
import { findEngines } from '../scripts/browser.mjs'
import { installProbe } from './fixtures/probe'
import { growth, readBar, readOutside, readPile, scrolled } from './fixtures/stage'
import { freePort } from './free-port'

// WebKitGTK's small browser by its own WebDriver: Safari's engine. Playwright's WebKit is another build.

const command = findEngines().find(({ name }) => name === 'WebKit')?.path

const STAGE = '[data-slot=gravity-stack]'
const chip = (n: number) => `${STAGE} > :nth-child(${n})`

/** A session of a WebDriver, or the driver itself. */
class WebDriver {
  constructor(readonly address: string) {}

  /** Asks, or tells where there is a body. */
  async send(path: string, body?: object) {
    const response = await fetch(this.address + path, body && { method: 'POST', body: JSON.stringify(body) })
    const { value } = await response.json()
    if (!response.ok) throw new Error(value.message)
    return value
  }

  /** Calls a function in the page. */
  evaluate<A extends unknown[], T>(work: (...args: A) => T, ...args: A): Promise<Awaited<T>> {
    return this.send('/execute/sync', { script: `return (${work})(...arguments)`, args })
  }

  async $eval<T>(selector: string, read: (element: HTMLElement) => T) {
    return this.evaluate(read, await this.send('/element', { using: 'css selector', value: selector }))
  }

  /** Writes a page into an empty one of its site, as WebDriver can't have the probe run before all else. */
  async open(url: string) {
    await this.send('/url', { url: new URL('/', url).href })
    await this.evaluate(
      async (url, probe) => {
        const page = await (await fetch(url)).text()
        document.open()
        document.write(page.replace('<head>', () => `<head><script>${probe}</script>`))
        document.close()
      },
      url,
      `(${installProbe})()`,
    )
  }

  act(type: 'pointer' | 'key', ...actions: object[]) {
    return this.send('/actions', { actions: [{ type, id: type, actions }] })
  }

  stateOf(selector: string) {
    return this.$eval(selector, (element) => element.dataset.state)
  }

  centreOf(selector: string) {
    return this.$eval(selector, (element) => {
      const { x, y, width, height } = element.getBoundingClientRect()
      return { x: Math.round(x + width / 2), y: Math.round(y + height / 2) }
    })
  }

  async reaches(state: string) {
    await expect.poll(() => this.stateOf(STAGE)).toBe(state)
  }

  /** Takes a chip by its centre to where it is to hang. */
  async carry(chip: string, x: number, y: number) {
    const from = await this.centreOf(chip)
    await this.act('pointer', { type: 'pointerMove', ...from }, { type: 'pointerDown', button: 0 })
    await this.reaches('running')
    expect(await this.stateOf(chip)).toBe('held')
    await this.act('pointer', { type: 'pointerMove', x, y, duration: 200 })
    const lag = async () => {
      const at = await this.centreOf(chip)
      return Math.hypot(at.x - x, at.y - y)
    }
    await expect.poll(lag).toBeLessThan(30)
  }

  async overlap() {
    const { shapes, poses, stage } = await this.$eval(STAGE, readPile)
    return worstOverlap(shapes, poses, stage)
  }
}

const test = base.extend<{ settings: string; webkit: WebDriver }>({
  settings: ['', { option: true }],
  webkit: async ({ settings }, use) => {
    const folder = mkdtempSync(join(tmpdir(), 'webkit-'))
    mkdirSync(join(folder, 'gtk-3.0'))
    writeFileSync(join(folder, 'gtk-3.0/settings.ini'), `[Settings]\n${settings}`)
    const screen = spawn('Xvfb', ['-displayfd', '1'], { stdio: ['ignore', 'pipe', 'ignore'] })
    const [display] = await once(screen.stdout, 'data')
    const port = await freePort()
    const driver = spawn(command!, [`--port=${port}`], {
      stdio: 'ignore',
      env: { ...process.env, DISPLAY: `:${display}`.trim(), GDK_BACKEND: 'x11', XDG_CONFIG_HOME: folder },
    })
    try {
      const server = new WebDriver(`http://127.0.0.1:${port}`)
      await expect(() => fetch(`${server.address}/status`)).toPass()
      const { sessionId } = await server.send('/session', { capabilities: {} })
      const page = new WebDriver(`${server.address}/session/${sessionId}`)
      await use(page)
      expect(await page.evaluate(() => window.probe.errors)).toEqual([])
    } finally {
      driver.kill()
      // The browser ends with its screen.
      screen.kill()
      rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
    }
  },
})

// Where there is none the totals say so.
if (command) {
  test('in WebKit chips fall, lie still and apart, can be carried, and no frame runs at rest', async ({
    webkit: page,
    baseURL,
  }) => {
    await page.open(`${baseURL}/pile?chips=12&shape=all&stagger=40`)
    await page.reaches('resting')
    expect(await page.overlap()).toBeLessThan(1)
    // A pill of 36 px.
    expect(await page.$eval(chip(1), (element) => element.style.borderRadius)).toBe('18px')

    await page.carry(chip(3), 320, 100)
    await page.act('pointer', { type: 'pointerUp', button: 0 })
    expect(await page.stateOf(chip(3))).toBe('falling')

    await page.reaches('resting')
    expect(await page.overlap()).toBeLessThan(1)
    expect(await page.evaluate(growth)).toBe(0)
  })

  test('in WebKit what reaches out of a full stage is cut off', async ({ webkit: page, baseURL }) => {
    await page.open(`${baseURL}/pile?chips=60&stagger=20&above=200&box=h-40%20w-64`)
    await page.reaches('resting')
    const { chips, pressed } = await page.$eval(STAGE, readOutside)
    expect(chips).toBeGreaterThan(3)
    expect(pressed).toBe(0)
  })

  test('in WebKit nothing in a stage scrolls, though its style says "overflow: hidden"', async ({
    webkit: page,
    baseURL,
  }) => {
    await page.open(`${baseURL}/pile?chips=3`)
    await page.reaches('resting')
    await page.$eval(STAGE, (stage) => stage.setAttribute('style', 'overflow: hidden'))
    expect(await page.$eval(STAGE, scrolled)).toBe(0)
  })

  test('in WebKit a chip of a stage in CSS columns hangs where it is held', async ({
    webkit: page,
    baseURL,
  }) => {
    await page.open(`${baseURL}/places?kind=columns`)
    await page.reaches('resting')
    await page.carry(chip(2), 240, 60)
  })

  test('in WebKit chips fall in a window that the page has opened', async ({ webkit: page, baseURL }) => {
    await page.open(`${baseURL}/surroundings?kind=popup`)
    const button = await page.centreOf('#open')
    await page.act(
      'pointer',
      { type: 'pointerMove', ...button },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    )
    const windows = (): Promise<string[]> => page.send('/window/handles')
    await expect.poll(async () => (await windows()).length).toBe(2)
    const handle = await page.send('/window')
    await page.send('/window', { handle: (await windows()).find((other) => other !== handle) })
    await page.reaches('resting')
    await page.send('/window', { handle })
  })

  test('in WebKit a drag on a link does not follow it; the key after a drag that no click follows does', async ({
    webkit: page,
    baseURL,
  }) => {
    await page.open(`${baseURL}/controls?stagger=40`)
    await page.reaches('resting')
    const { x, y } = await page.centreOf('[data-name=link]')
    await page.act(
      'pointer',
      { type: 'pointerMove', x, y },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerMove', x, y: y - 60, duration: 100 },
    )
    expect(await page.stateOf(chip(1))).toBe('held')
    // The browser takes the pointer away: what comes next is no click of this drag.
    await page.$eval('[data-name=link]', (link) => {
      window.dispatchEvent(new PointerEvent('pointercancel', { pointerId: 1 }))
      link.focus()
    })
    const hash = () => page.evaluate(() => location.hash)
    expect(await hash()).toBe('')
    await page.act('key', { type: 'keyDown', value: '\uE007' }, { type: 'keyUp', value: '\uE007' })
    await expect.poll(hash).toBe('#link')
    await page.act('pointer', { type: 'pointerUp', button: 0 })
  })

  test('in WebKit a press on a video with controls is the video’s', async ({ webkit: page, baseURL }) => {
    await page.open(`${baseURL}/surroundings?kind=video`)
    await page.reaches('resting')
    const { x, y } = await page.centreOf(chip(1))
    await page.act(
      'pointer',
      { type: 'pointerMove', x, y },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerMove', x: x + 10, y: y - 60, duration: 100 },
    )
    expect(await page.stateOf(chip(1))).toBe('resting')
    await page.act('pointer', { type: 'pointerUp', button: 0 })
  })

  test.describe('in WebKit with bars that take room', () => {
    test.use({ settings: 'gtk-overlay-scrolling=0' })

    test('the scroll bar of a card scrolls the card, which is not held meanwhile', async ({
      webkit: page,
      baseURL,
    }) => {
      await page.open(`${baseURL}/surroundings?kind=card`)
      await page.reaches('resting')
      const card = `${chip(1)} > div`
      const [from, to] = await page.$eval(card, readBar)
      await page.act(
        'pointer',
        { type: 'pointerMove', ...from },
        { type: 'pointerDown', button: 0 },
        { type: 'pointerMove', ...to, duration: 200 },
      )
      await expect.poll(() => page.$eval(card, (element) => element.scrollTop)).toBeGreaterThan(30)
      expect(await page.stateOf(chip(1))).toBe('resting')
      await page.act('pointer', { type: 'pointerUp', button: 0 })
    })
  })

  test.describe('in WebKit with reduced motion', () => {
    test.use({ settings: 'gtk-enable-animations=0' })

    test('the chips stand in a row, and nothing moves', async ({ webkit: page, baseURL }) => {
      await page.open(`${baseURL}/pile?chips=4`)
      await page.evaluate(() => window.probe.pass(20))
      expect(await page.stateOf(STAGE)).toBe('static')
      expect(await page.evaluate(() => window.probe.frames)).toBe(0)
      const { shapes, poses } = await page.$eval(STAGE, readPile)
      expect(poses.map(({ x, y }, i) => [x - shapes[i].width / 2, y - shapes[i].height / 2])).toEqual(
        poses.map(() => [0, 0]),
      )
      const tops = await page.$eval(STAGE, (stage) =>
        Array.from(stage.children, (one) => one.getBoundingClientRect().y),
      )
      expect(new Set(tops).size).toBe(1)
    })

    test('words can be selected in the row', async ({ webkit: page, baseURL }) => {
      await page.open(`${baseURL}/pile?chips=4`)
      const press = [
        { type: 'pointerDown', button: 0 },
        { type: 'pointerUp', button: 0 },
      ]
      await page.act(
        'pointer',
        { type: 'pointerMove', ...(await page.centreOf(chip(1))) },
        ...press,
        ...press,
      )
      expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe('design')
    })
  })
}
