import { expect, type StagePage, test } from './fixtures/stage'

/** What each chip tells of its angle, and the angle that it is drawn at, degrees. */
const angles = (stage: StagePage) =>
  stage.chips.evaluateAll((all) =>
    all.map((chip) => {
      const style = getComputedStyle(chip)
      const turn = new DOMMatrix(style.transform)
      return {
        told: style.getPropertyValue('--chip-angle'),
        drawn: (Math.atan2(turn.b, turn.a) * 180) / Math.PI,
      }
    }),
  )

test('a chip tells the angle at which it lies once the pile rests, and none while it moves', async ({
  stage,
  page,
}) => {
  await stage.open('pile', { chips: 12 })
  await expect(stage.chips.nth(5)).toHaveAttribute('data-state', 'falling')
  for (const { told } of await angles(stage)) expect(told).toBe('')
  await stage.reaches('resting')
  const resting = await angles(stage)
  for (const { told, drawn } of resting) {
    expect(told).toMatch(/^-?\d+deg$/)
    // Half a turn to the left is half a turn to the right.
    const apart = Math.abs(Number.parseFloat(told) - drawn)
    expect(Math.min(apart, 360 - apart)).toBeLessThan(0.51)
  }
  expect(new Set(resting.map(({ told }) => told)).size).toBeGreaterThan(3)

  await stage.drag(stage.chips.nth(0), 0, -120)
  await expect(stage.chips.nth(0)).toHaveAttribute('data-state', 'held')
  expect((await angles(stage))[0].told).toBe('')
  await page.mouse.up()
  await stage.reaches('resting')
  for (const { told } of await angles(stage)) expect(told).not.toBe('')
})

test('in the row of reduced motion and print every chip tells that it is level', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 12 })
  for (const media of [{ reducedMotion: 'reduce' }, { reducedMotion: null, media: 'print' }] as const) {
    await page.emulateMedia(media)
    await stage.reaches('static')
    for (const angle of await angles(stage)) expect(angle).toEqual({ told: '0deg', drawn: 0 })
  }
  await page.emulateMedia({ media: null })
  await stage.reaches('resting')
  expect(new Set((await angles(stage)).map(({ told }) => told)).size).toBeGreaterThan(3)
})
