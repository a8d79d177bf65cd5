import { expect, test } from './fixtures/stage'

const values = ['nan', 'infinity', 'minus infinity', 'negative', 'huge', 'null', 'text', 'object']

for (const prop of ['gravity', 'bounce', 'stagger', 'friction']) {
  test(`whatever ${prop} is given, the chips fall and rest, and a developer is told why`, async ({
    stage,
  }) => {
    for (const value of values) {
      await stage.open('inputs', { prop, value })
      if (prop === 'stagger' && value === 'huge') {
        // A minute between releases, at most.
        await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
      } else {
        await stage.reaches('resting')
        expect(await stage.overlap(), value).toBeLessThan(1)
      }
      const warnings = await stage.probe((probe) => probe.warnings)
      expect(warnings.join(), value).toContain(`GravityStack: ${prop} is`)
    }
  })
}

const children: Record<string, { chips: number; falling: number; warns?: string }> = {
  none: { chips: 2, falling: 2 },
  null: { chips: 2, falling: 2 },
  false: { chips: 2, falling: 2 },
  number: { chips: 3, falling: 3 },
  array: { chips: 4, falling: 4 },
  component: { chips: 3, falling: 2, warns: 'no size' },
  portal: { chips: 3, falling: 2, warns: 'no size' },
  zero: { chips: 3, falling: 2, warns: 'no size' },
  flat: { chips: 3, falling: 2, warns: 'no size' },
  undisplayed: { chips: 3, falling: 2, warns: 'no size' },
  absolute: { chips: 3, falling: 2, warns: 'no size' },
  image: { chips: 3, falling: 2, warns: 'no size' },
  inline: { chips: 3, falling: 3 },
  margin: { chips: 3, falling: 3 },
  large: { chips: 3, falling: 3, warns: 'larger than its stage' },
  tiny: { chips: 3, falling: 3 },
  ellipse: { chips: 3, falling: 3 },
}

for (const [kind, { chips, falling, warns }] of Object.entries(children)) {
  test(`a child of the kind "${kind}" does no harm to the others`, async ({ stage, page }) => {
    await stage.settled('inputs', { children: kind })
    await expect(stage.chips).toHaveCount(chips)
    const states = await stage.states()
    expect(states.filter((state) => state === 'resting')).toHaveLength(falling)
    const warnings = (await stage.probe((probe) => probe.warnings)).join()
    if (warns) expect(warnings).toContain(warns)
    else expect(warnings).toBe('')
    await page.locator('#toggle').click()
    await page.locator('#toggle').click()
    await stage.reaches('running')
    await stage.reaches('resting')
    expect(await stage.during('frames')).toBe(0)
  })
}
