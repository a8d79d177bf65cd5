import { expect, type Page } from '@playwright/test'
import { playgroundStage, test } from './page'

test.use({ permissions: ['clipboard-read', 'clipboard-write'] })

const stageOf = (page: Page) => page.locator(playgroundStage)
const obstacleOf = (page: Page) => page.getByRole('button', { name: 'Obstacle' })

async function expectRest(page: Page) {
  await expect(stageOf(page)).toHaveAttribute('data-state', 'resting')
}

/** Until something moves and lies still again. */
async function expectAnotherRest(page: Page) {
  await expect(stageOf(page)).not.toHaveAttribute('data-state', 'resting')
  await expectRest(page)
}

/** Middles of the chips, px of the stage. */
const middles = (page: Page) =>
  stageOf(page).evaluate((stage) => {
    const { left, top } = stage.getBoundingClientRect()
    return [...stage.querySelectorAll('[data-chip]')].map((chip) => {
      const box = chip.getBoundingClientRect()
      return { x: box.x + box.width / 2 - left, y: box.y + box.height / 2 - top }
    })
  })

const mean = (all: number[]) => all.reduce((sum, n) => sum + n, 0) / all.length

/** Chips whose middle is over the obstacle, and higher than it. */
async function carried(page: Page) {
  const [box, stage] = [(await obstacleOf(page).boundingBox())!, (await stageOf(page).boundingBox())!]
  const all = await middles(page)
  return all.filter(
    ({ x, y }) => Math.abs(x + stage.x - box.x - box.width / 2) < box.width / 2 && y + stage.y < box.y,
  ).length
}

test('gravity that a slider turns to the right takes the pile to the right wall, and upwards under the closed top', async ({
  page,
}) => {
  await page.goto('/playground?count=8&stagger=20')
  await expectRest(page)
  const { width } = (await stageOf(page).boundingBox())!
  const direction = page.getByRole('slider', { name: 'Direction' })
  await direction.focus()
  await page.keyboard.press('ArrowRight')
  await expect(direction).toHaveValue('5')
  await direction.fill('90')
  await expect(direction).toHaveAttribute('aria-valuetext', '90° right')
  await expect(page.getByText('<GravityStack gravity={{ x: 2600, y: 0 }}')).toBeVisible()
  await expectAnotherRest(page)
  expect(mean((await middles(page)).map(({ x }) => x))).toBeGreaterThan(0.7 * width)

  const ceiling = page.getByRole('checkbox', { name: 'ceiling' })
  await expect(ceiling).not.toBeChecked()
  await direction.fill('180')
  await expect(ceiling).toBeChecked()
  await expect(ceiling).toBeDisabled()
  await expect(page.getByText('gravity={{ x: 0, y: -2600 }} ceiling')).toBeVisible()
  await expectAnotherRest(page)
  const high = (await middles(page)).map(({ y }) => y)
  expect(mean(high)).toBeLessThan(110)
  expect(Math.min(...high)).toBeGreaterThan(0)
  await expect(page).toHaveURL(/direction=180/)
  await page.reload()
  await expect(direction).toHaveValue('180')
})

test('under a ceiling a chip that is tossed up stays in the stage', async ({ page }) => {
  await page.goto('/playground?count=1&stagger=0')
  await expectRest(page)
  await page.getByRole('checkbox', { name: 'ceiling' }).check()
  await expect(page.getByText('<GravityStack ceiling stagger={0}')).toBeVisible()
  const { height } = (await stageOf(page).boundingBox())!
  await stageOf(page).scrollIntoViewIfNeeded()
  const chip = (await stageOf(page).locator('[data-chip]').boundingBox())!
  await page.mouse.move(chip.x + chip.width / 2, chip.y + chip.height / 2)
  await page.mouse.down()
  // A hand far above the stage leaves the chip under its top.
  await page.mouse.move(chip.x + chip.width / 2, chip.y - height - 30, { steps: 20 })
  await expect.poll(async () => (await middles(page))[0].y).toBeLessThan(height / 2)
  await page.mouse.up()
  await expectRest(page)
  for (const { y } of await middles(page)) expect(y).toBeGreaterThan(0)
})

test('with push a mouse that moves over the stage shoves the pile, and without it does not', async ({
  page,
}) => {
  await page.goto('/playground?count=8&stagger=20')
  await expectRest(page)
  const sweep = async () => {
    await stageOf(page).scrollIntoViewIfNeeded()
    const { x, y, width, height } = (await stageOf(page).boundingBox())!
    await page.mouse.move(x + 10, y + height - 20)
    await page.mouse.move(x + width - 10, y + height - 20, { steps: 20 })
  }
  const before = await middles(page)
  await sweep()
  expect(await middles(page)).toEqual(before)
  await page.getByRole('slider', { name: 'push' }).fill('44')
  await expect(page.getByText('<GravityStack push={44} stagger={20}')).toBeVisible()
  await sweep()
  await expectAnotherRest(page)
  const after = await middles(page)
  expect(after.filter((at, i) => Math.abs(at.x - before[i].x) > 5).length).toBeGreaterThan(2)
})

test('an obstacle comes into the stage, carries chips, and is dragged and moved by keys from under them', async ({
  page,
}) => {
  await page.goto('/playground?count=14&stagger=20&obstacle=true&obstacleY=70')
  await expectRest(page)
  expect(await carried(page)).toBeGreaterThan(0)
  const obstacle = obstacleOf(page)
  const before = await middles(page)
  const box = (await obstacle.boundingBox())!
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x - 150, y - 60, { steps: 10 })
  await page.mouse.up()
  await expectAnotherRest(page)
  const dragged = (await obstacle.boundingBox())!
  expect(Math.abs(dragged.x - box.x + 150)).toBeLessThan(2)
  expect(Math.abs(dragged.y - box.y + 60)).toBeLessThan(2)
  expect(await middles(page)).not.toEqual(before)
  // Let go, it stays where it is.
  await page.mouse.move(x, y)
  expect(await obstacle.boundingBox()).toEqual(dragged)

  await obstacle.focus()
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('ArrowUp')
  const pressed = (await obstacle.boundingBox())!
  expect(Math.abs(pressed.x - dragged.x - 16)).toBeLessThan(2)
  expect(Math.abs(pressed.y - dragged.y + 16)).toBeLessThan(2)
  await page.keyboard.press('Shift+ArrowDown')
  expect((await obstacle.boundingBox())!.y - pressed.y).toBeLessThan(4)
  const value = await page.getByRole('slider', { name: 'Obstacle from the left' }).inputValue()
  await expect(page.getByText(`<div data-static className="absolute top-`)).toContainText(`left-[${value}%]`)
  await expect(page).toHaveURL(new RegExp(`obstacleX=${value}`))
  await expectRest(page)
  const lying = await middles(page)
  await page.getByRole('checkbox', { name: 'Obstacle' }).uncheck()
  await expect(obstacle).toHaveCount(0)
  await expect(page.getByText('data-static')).toHaveCount(0)
  await expectRest(page)
  expect((await middles(page)).length).toBe(lying.length)
})

test('in a paused stage too an obstacle that is dragged into the pile leaves no chip inside it', async ({
  page,
}) => {
  await page.goto('/playground?count=1&stagger=0&shape=boxes&obstacle=true&obstacleX=10&obstacleY=30')
  await expectRest(page)
  await page.getByRole('button', { name: 'Pause' }).click()
  const chip = stageOf(page).locator('[data-chip]')
  const lying = (await chip.boundingBox())!
  const held = (await obstacleOf(page).boundingBox())!
  await page.mouse.move(held.x + held.width / 2, held.y + held.height / 2)
  await page.mouse.down()
  await page.mouse.move(lying.x + lying.width / 2, lying.y + lying.height / 2, { steps: 5 })
  await page.mouse.up()
  await expect.poll(() => chip.boundingBox()).not.toEqual(lying)
  const [a, b] = [(await chip.boundingBox())!, (await obstacleOf(page).boundingBox())!]
  const apart = Math.max(b.x - a.x - a.width, a.x - b.x - b.width, b.y - a.y - a.height, a.y - b.y - b.height)
  expect(apart).toBeGreaterThan(-1)
})

test('the link of a pile on an obstacle shows the obstacle where it was, and the same pile on it', async ({
  page,
}) => {
  await page.goto('/playground?count=6&stagger=20&obstacle=true')
  await expectRest(page)
  await obstacleOf(page).focus()
  await page.keyboard.press('ArrowLeft')
  await expectAnotherRest(page)
  await page.getByRole('button', { name: 'Copy this pile' }).click()
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
  const [obstacle, chips] = [await obstacleOf(page).boundingBox(), await middles(page)]
  const link = new URL(await page.evaluate(() => navigator.clipboard.readText()))
  link.search = '?count=6'
  await page.goto(link.href)
  await expect(stageOf(page)).toHaveAttribute('data-outcome', 'same')
  const shown = (await stageOf(page).locator('[data-static]').boundingBox())!
  expect(Math.abs(shown.x - obstacle!.x)).toBeLessThan(0.1)
  expect(Math.abs(shown.y - obstacle!.y)).toBeLessThan(0.1)
  for (const [i, { y }] of (await middles(page)).entries()) expect(Math.abs(y - chips[i].y)).toBeLessThan(0.1)
})

test('in a narrower window the obstacle keeps its place in the stage, with chips on it', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 })
  await page.goto('/playground?count=14&stagger=20&obstacle=true&obstacleX=75&obstacleY=50')
  await expectRest(page)
  await page.setViewportSize({ width: 500, height: 800 })
  await expectAnotherRest(page)
  const [box, stage] = [(await obstacleOf(page).boundingBox())!, (await stageOf(page).boundingBox())!]
  expect((box.x + box.width / 2 - stage.x) / stage.width).toBeCloseTo(0.75, 1)
})
