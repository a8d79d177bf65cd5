import { expect, type Locator, type Page } from '@playwright/test'
import { test } from './page'

/**
 * The shadows of what each chip shows, px down and to the right on the screen, and the angle of the chip,
 * degrees. Runs in the page.
 */
function readLight(root: Element) {
  return [...root.querySelectorAll('[data-slot=gravity-stack-chip]')].map((chip) => {
    const turn = new DOMMatrix(getComputedStyle(chip).transform)
    const [face] = chip.children
    const { boxShadow } = getComputedStyle(face)
    const shadows = [...boxShadow.matchAll(/(-?[\d.e-]+)px (-?[\d.e-]+)px [\d.]+px [\d.]+px( inset)?/g)]
      .map(([, x, y, inset]) => ({
        inset: Boolean(inset),
        right: turn.a * Number(x) + turn.c * Number(y),
        down: turn.b * Number(x) + turn.d * Number(y),
      }))
      .filter(({ right, down }) => Math.hypot(right, down) > 0.01)
    return { angle: (Math.atan2(turn.b, turn.a) * 180) / Math.PI, shadows }
  })
}

/** Expects light from straight above on every chip of a stage. */
async function litFromAbove(root: Locator) {
  await expect(async () => {
    const chips = await root.evaluate(readLight)
    for (const { angle, shadows } of chips) {
      // The lit edge above and the shadow below both stand down from where nothing is lit; the edge below
      // stands up.
      expect(shadows.length).toBeGreaterThan(2)
      // The angle is told in whole degrees: half of one moves the longest shadow, of 18 px, by 0.16 px.
      for (const { right } of shadows) expect(Math.abs(right), `at ${angle.toFixed()}°`).toBeLessThan(0.2)
      const outer = shadows.filter(({ inset }) => !inset)
      for (const { down } of outer) expect(down, `at ${angle.toFixed()}°`).toBeGreaterThan(0.9)
      const [lit, turned] = shadows.filter(({ inset }) => inset)
      expect(lit.down).toBeCloseTo(1, 1)
      expect(turned.down).toBeLessThan(-0.9)
    }
  }).toPass()
}

const stageOf = (page: Page) =>
  page.locator('[data-slot=gravity-stack]', { has: page.getByText('Porcelain', { exact: true }) })

test('shadows fall down the screen from chips that lie at an angle, and again after a toss', async ({
  page,
}) => {
  await page.goto('/docs/gravity-stack')
  const stage = stageOf(page)
  await stage.scrollIntoViewIfNeeded()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  const angles = (await stage.evaluate(readLight)).map(({ angle }) => Math.abs(angle))
  expect(Math.max(...angles)).toBeGreaterThan(20)
  await litFromAbove(stage)

  const box = (await stage.getByText('Porcelain', { exact: true }).boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + 40, box.y - 120, { steps: 8 })
  await page.mouse.up()
  await expect(stage).toHaveAttribute('data-state', 'running')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await litFromAbove(stage)
})

test('in the row of reduced motion and print, light falls from above too, though the pile lay at an angle', async ({
  page,
}) => {
  await page.goto('/docs/gravity-stack')
  const stage = stageOf(page)
  await stage.scrollIntoViewIfNeeded()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  for (const media of [{ reducedMotion: 'reduce' }, { reducedMotion: null, media: 'print' }] as const) {
    await page.emulateMedia(media)
    await expect(stage).toHaveAttribute('data-state', 'static')
    expect((await stage.evaluate(readLight)).map(({ angle }) => angle)).toEqual(Array(10).fill(0))
    await litFromAbove(stage)
  }
})

test('the steps of the ladder, which are no chips, are lit from above', async ({ page }) => {
  await page.goto('/docs/elevation')
  const shadows = await page
    .getByText('Step 4')
    .evaluateAll((all) => all.map((step) => getComputedStyle(step).boxShadow))
  expect(shadows).toHaveLength(2)
  for (const shadow of shadows) {
    expect(shadow).toMatch(/ 0px 1px 0px 0px inset/)
    expect(shadow).toMatch(/ 0px 18px 32px 0px$/)
  }
})

test('on the playground too, neutral chips at rest are lit from above', async ({ page }) => {
  await page.goto('/playground?look=neutral&count=6')
  await expect(page.locator('[data-slot=playground-stage]')).toHaveAttribute('data-state', 'resting')
  const sideways = () =>
    page.locator('[data-chip]').evaluateAll((all) =>
      all.map((chip) => {
        const turn = new DOMMatrix(getComputedStyle(chip).transform)
        const [, x, y] = /(-?[\d.e-]+)px (-?[\d.e-]+)px 12px 0px$/.exec(
          getComputedStyle(chip.children[0]).boxShadow,
        )!
        return Math.abs(turn.a * Number(x) + turn.c * Number(y))
      }),
    )
  await expect.poll(async () => Math.max(...(await sideways()))).toBeLessThan(0.1)
})
