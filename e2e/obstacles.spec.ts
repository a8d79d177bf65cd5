import { expect, type Page } from '@playwright/test'
import { test } from './page'

const chips = '[data-slot=gravity-stack-chip]'

/** The example in the docs that has a chip with that word, once its pile lies still. */
async function example(page: Page, word: string) {
  await page.goto('/docs/gravity-stack')
  const stage = page.locator('[data-slot=gravity-stack]', { hasText: word })
  const box = stage.locator('..')
  await stage.scrollIntoViewIfNeeded()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  /** Middles of the chips, as shares of the stage. */
  const middles = () =>
    stage.evaluate((root, chips) => {
      const { left, top, width, height } = root.getBoundingClientRect()
      return [...root.querySelectorAll(chips)].map((chip) => {
        const box = chip.getBoundingClientRect()
        return { x: (box.x + box.width / 2 - left) / width, y: (box.y + box.height / 2 - top) / height }
      })
    }, chips)
  const mean = async (axis: 'x' | 'y') => {
    const all = await middles()
    return all.reduce((sum, middle) => sum + middle[axis], 0) / all.length
  }
  return { box, stage, middles, mean }
}

test('the example Shelves has chips at rest on its turned planks, not only on the floor', async ({
  page,
}) => {
  const { stage, middles } = await example(page, 'lentils')
  await expect(stage.locator('[data-static]')).toHaveCount(3)
  const all = await middles()
  expect(all).toHaveLength(12)
  for (const { x, y } of all) expect(x > 0 && x < 1 && y > 0 && y < 1).toBe(true)
})

test('the example Falling up has its pile under the top, all of it inside', async ({ page }) => {
  const { middles, mean } = await example(page, 'balloons')
  expect(await mean('y')).toBeLessThan(0.35)
  for (const { y } of await middles()) expect(y).toBeGreaterThan(0)
})

test('in the example Push a mouse that moves over the pile shoves it', async ({ page }) => {
  const { stage } = await example(page, 'acorn')
  const { x, y, width, height } = (await stage.boundingBox())!
  await page.mouse.move(x + 20, y + height - 20)
  await page.mouse.move(x + width - 20, y + height - 20, { steps: 20 })
  await expect(stage).not.toHaveAttribute('data-state', 'resting')
  await expect(stage).toHaveAttribute('data-state', 'resting')
})

test('in the example Tilt buttons move the pile, and a switch shows only where there is a sensor', async ({
  page,
}) => {
  // Nobody has to be asked, as in Firefox.
  await page.addInitScript(() => Reflect.deleteProperty(DeviceOrientationEvent, 'requestPermission'))
  const { box, stage, mean } = await example(page, 'marble')
  const follow = box.getByRole('switch', { name: 'Follow the phone' })
  await expect(follow).toHaveCount(0)
  await box.getByRole('button', { name: 'Right' }).click()
  await expect(stage).not.toHaveAttribute('data-state', 'resting')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  expect(await mean('x')).toBeGreaterThan(0.6)
  const tilt = (beta: number, gamma: number) =>
    page.evaluate(
      ([beta, gamma]) =>
        window.dispatchEvent(new DeviceOrientationEvent('deviceorientation', { beta, gamma })),
      [beta, gamma],
    )
  // The sensor tells of itself, and moves nothing before it is asked to.
  await tilt(0, -60)
  await expect(follow).toHaveAttribute('aria-checked', 'false')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await follow.click()
  await expect(follow).toHaveAttribute('aria-checked', 'true')
  await tilt(0, -60)
  await expect(stage).not.toHaveAttribute('data-state', 'resting')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  expect(await mean('x')).toBeLessThan(0.4)
  // A button takes over.
  await box.getByRole('button', { name: 'Down' }).click()
  await expect(follow).toHaveAttribute('aria-checked', 'false')
})

test('on iOS the example Tilt asks for the sensor in a tap, and stays off where that is denied', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const asked: string[] = []
    const answers = ['denied', 'granted']
    Object.assign(window, { asked })
    Object.defineProperty(navigator, 'maxTouchPoints', { value: 5 })
    Object.assign(DeviceOrientationEvent, {
      requestPermission: async () => {
        asked.push(navigator.userActivation.isActive ? 'in a tap' : 'unasked')
        return answers.shift()
      },
    })
  })
  const { box } = await example(page, 'marble')
  const follow = box.getByRole('switch', { name: 'Follow the phone' })
  await follow.click()
  await expect(follow).toHaveAttribute('aria-checked', 'false')
  await follow.click()
  await expect(follow).toHaveAttribute('aria-checked', 'true')
  expect(await page.evaluate('asked')).toEqual(['in a tap', 'in a tap'])
})

test('the block Hero has chips at rest on its heading, and its button can be pressed', async ({ page }) => {
  await page.goto('/blocks/gravity-hero')
  await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
  const heading = (await page.getByRole('heading').boundingBox())!
  const boxes = await Promise.all((await page.locator(chips).all()).map((chip) => chip.boundingBox()))
  const on = boxes.filter((box) => box!.y + box!.height / 2 < heading.y)
  expect(on.length).toBeGreaterThan(0)
  await page.getByRole('link', { name: 'Start for free' }).click({ trial: true })
})
