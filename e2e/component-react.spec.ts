import type { Page } from '@playwright/test'
import { expect, StagePage, test } from './fixtures/stage'

declare global {
  interface Window {
    /** Transforms of the chips when the stage's state first changed. */
    shown?: string[]
  }
}

for (const react of ['18', '19']) {
  test.describe(`React ${react}`, () => {
    test('server markup is hydrated in StrictMode without a word, and the chips fall once', async ({
      stage,
    }) => {
      await stage.settled('pile', { react, chips: 6 })
      expect(await stage.overlap()).toBeLessThan(1)
      expect(await stage.probe(({ errors, warnings }) => [...errors, ...warnings])).toEqual([])
      expect(await stage.probe((probe) => probe.states)).toEqual(['waiting', 'running', 'resting'])
    })

    test('ref and actions work', async ({ stage, page }) => {
      await stage.settled('extras', { react })
      await page.locator('#read').click()
      await expect(page.locator('#tag')).toHaveText('stage gravity-stack')
      await page.locator('#shake').click()
      await stage.reaches('running')
      await stage.reaches('resting')
      await expect(page.locator('#settled')).toHaveText('2')
    })

    test('children that have not come yet, as async server components, are chips once they have', async ({
      stage,
      page,
    }) => {
      await stage.settled('surroundings', { react, kind: 'late' })
      await expect(stage.chips).toHaveText(['alone'])
      const second = new StagePage(page, page.locator('[data-slot=gravity-stack]').nth(1))
      await expect(second.chips).toHaveText(['first', 'alone', 'one of two', 'two of two'])
      await second.reaches('resting')
      expect(await second.overlap()).toBeLessThan(1)
    })

    test('children come and go', async ({ stage, page }) => {
      await stage.settled('children', { react })
      await page.locator('#extra').click()
      await page.locator('#add').click()
      await expect(stage.chips).toHaveCount(14)
      await stage.reaches('running')
      await stage.reaches('resting')
      await page.evaluate(() => window.remove('one'))
      await expect(stage.chips).toHaveCount(13)
      await stage.reaches('resting')
      expect(await stage.overlap()).toBeLessThan(1)
    })
  })
}

test.describe('in an Activity that is hidden and shown again', () => {
  /** The stage is out of sight, and nothing of the page is watched for it. */
  async function hide(stage: StagePage, page: Page) {
    await page.locator('#next').click()
    await expect(stage.root).toBeHidden()
    await expect.poll(() => stage.probe(({ observed }) => observed.intersection)).toBe(0)
    await stage.isGone()
    expect(await stage.probe((probe) => probe.timers)).toBe(0)
  }

  test('chips fall on from where they were, what was changed meanwhile falls anew', async ({
    stage,
    page,
  }) => {
    await stage.open('surroundings', { kind: 'hidden' })
    await expect(stage.chip('four')).toHaveAttribute('data-state', 'falling')
    await hide(stage, page)
    await expect(stage.root).toHaveAttribute('data-state', 'paused')
    const drawn = () =>
      stage.chips.evaluateAll((all) => all.map((chip) => (chip as HTMLElement).style.transform))
    const before = await drawn()
    expect(before).toHaveLength(3)
    await page.evaluate(() => {
      new MutationObserver(() => {
        window.shown ??= [...document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')].map(
          (chip) => chip.style.transform,
        )
      }).observe(document.querySelector('[data-slot=gravity-stack]')!, { attributeFilter: ['data-state'] })
    })
    await page.locator('#next').click()
    await stage.reaches('resting')
    // As it begins to run nothing has moved yet.
    expect((await page.evaluate(() => window.shown))!.slice(0, 3)).toEqual(before)
    const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
    expect(released.sort()).toEqual([0, 1, 2, 3, 3])
    expect(await stage.states()).toEqual(Array(4).fill('resting'))
    expect(await stage.overlap()).toBeLessThan(1)
  })

  test('walls that move later push the pile aside as ever', async ({ stage, page }) => {
    await stage.settled('surroundings', { kind: 'hidden' })
    await hide(stage, page)
    await page.locator('#next').click()
    await stage.reaches('resting')
    await stage.root.evaluate((root) => {
      root.style.width = '260px'
    })
    await stage.probe((probe) => probe.pass(3))
    await stage.reaches('resting')
    expect(await stage.outside()).toBeLessThan(1)
    expect(await stage.overlap()).toBeLessThan(1)
  })

  test('a paused pile is still there, and still paused', async ({ stage, page }) => {
    await stage.settled('surroundings', { kind: 'hidden' })
    await page.locator('#pause').click()
    const { poses } = await stage.pile()
    await hide(stage, page)
    await page.locator('#next').click()
    await expect(stage.root).toBeVisible()
    await expect.poll(() => stage.probe(({ observed }) => observed.intersection)).toBe(1)
    await stage.reaches('paused')
    expect((await stage.pile()).poses.slice(0, 3)).toEqual(poses.slice(0, 3))
    await page.locator('#drop').click()
    await stage.reaches('resting')
  })
})

test('ref, native props and style reach the stage', async ({ stage, page }) => {
  await stage.settled('extras')
  await expect(stage.root).toHaveAttribute('id', 'stage')
  await expect(stage.root).toHaveAttribute('title', 'pile')
  await expect(page.getByRole('group', { name: 'Topics' })).toHaveCount(1)
  await expect(stage.root).toHaveCSS('outline-style', 'solid')
  await page.locator('#read').click()
  await expect(page.locator('#tag')).toHaveText('stage gravity-stack')
})

test('a new gravity takes hold of the pile as it lies', async ({ stage, page }) => {
  await stage.settled('extras')
  const { poses } = await stage.pile()
  await page.locator('#heavy').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  for (const [i, { x, y }] of (await stage.pile()).poses.entries()) {
    expect(Math.hypot(x - poses[i].x, y - poses[i].y)).toBeLessThan(20)
  }
})

test('interactive takes effect at once, both ways, and lets go of what is held', async ({ stage, page }) => {
  await stage.settled('extras')
  const chip = stage.chips.nth(0)
  await stage.drag(chip, 10, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.locator('#still').evaluate((button: HTMLElement) => button.click())
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await stage.reaches('resting')
  await stage.drag(chip, 10, -60)
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await page.locator('#still').click()
  await stage.drag(chip, 10, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
})

test('a stage whose `interactive` changes before anyone has seen it drops as ever', async ({
  stage,
  page,
}) => {
  await page.addInitScript(() =>
    addEventListener('DOMContentLoaded', () => {
      document.body.style.paddingTop = '3000px'
    }),
  )
  await stage.open('extras')
  await page.waitForFunction(() => window.kept?.length)
  await page.locator('#still').evaluate((button: HTMLElement) => button.click())
  await page.evaluate(() => scrollTo(0, 3000))
  await stage.reaches('running')
  await stage.reaches('resting')
})

test('a chip stays held when a render brings another object for `interactive`', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'truthy' })
  await stage.drag(stage.chips.first(), 20, -60)
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.locator('#next').evaluate((button: HTMLElement) => button.click())
  await page.evaluate(() => window.probe.pass(3))
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await stage.reaches('resting')
})
