import { expect, type StagePage, test } from './fixtures/stage'

const values = ['nan', 'infinity', 'minus infinity', 'negative', 'huge', 'null', 'text', 'digits', 'object']

/** Each value has a page of its own, and only the last one is looked at when a test ends. */
const unharmed = async (stage: StagePage, value: string) =>
  expect(await stage.probe((probe) => probe.errors), value).toEqual([])

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
      // What is wrong, what becomes of it, and what to do.
      const told = new RegExp(
        `GravityStack: ${prop} is .+, so .+ stands in for it\\. Pass .+ or leave ${prop} out\\.`,
      )
      expect(warnings.join(), value).toMatch(told)
      await unharmed(stage, value)
    }
  })
}

test('whatever interactive is given counts as true or false, and a developer is told which', async ({
  stage,
}) => {
  const on = ['infinity', 'minus infinity', 'negative', 'huge', 'text', 'digits', 'object']
  for (const value of values) {
    await stage.settled('inputs', { prop: 'interactive', value })
    const counted = on.includes(value)
    const cursor = await stage.chips.first().evaluate((chip) => getComputedStyle(chip).cursor)
    expect(cursor === 'grab', value).toBe(counted)
    const warnings = await stage.probe((probe) => probe.warnings)
    expect(warnings.join(), value).toMatch(
      new RegExp(`GravityStack: interactive is .+, so it counts as ${counted}\\. Pass true or false\\.`),
    )
    await unharmed(stage, value)
  }
})

test('an onSettle that can’t be called is not, and a developer is told so', async ({ stage }) => {
  for (const value of [...values, 'false']) {
    await stage.settled('inputs', { prop: 'onSettle', value })
    const warnings = (await stage.probe((probe) => probe.warnings)).join()
    // null, NaN and false are common ways to leave it out.
    if (['null', 'nan', 'false'].includes(value)) expect(warnings, value).toBe('')
    else expect(warnings, value).toMatch(/GravityStack: onSettle is .+, so nothing is\. Pass a function/)
    await unharmed(stage, value)
  }
})

test('whatever className is given, the chips fall and rest', async ({ stage }) => {
  for (const value of values) {
    await stage.settled('inputs', { prop: 'className', value })
    expect(new Set(await stage.states()), value).toEqual(new Set(['resting']))
    expect(await stage.overlap(), value).toBeLessThan(1)
    await unharmed(stage, value)
  }
})

const children: Record<string, { chips: number; falling: number; warns?: string }> = {
  none: { chips: 2, falling: 2 },
  null: { chips: 2, falling: 2 },
  false: { chips: 2, falling: 2 },
  number: { chips: 3, falling: 3 },
  empty: { chips: 2, falling: 2 },
  blanks: { chips: 3, falling: 3 },
  array: { chips: 4, falling: 4 },
  fragment: { chips: 4, falling: 4 },
  deaf: { chips: 3, falling: 3 },
  restless: { chips: 3, falling: 3 },
  component: { chips: 3, falling: 2, warns: 'no size' },
  portal: { chips: 3, falling: 2, warns: 'no size' },
  zero: { chips: 3, falling: 2, warns: 'no size' },
  flat: { chips: 3, falling: 2, warns: 'no size' },
  undisplayed: { chips: 3, falling: 2, warns: 'no size' },
  absolute: { chips: 3, falling: 2, warns: 'no size' },
  image: { chips: 3, falling: 2, warns: 'no size' },
  inline: { chips: 3, falling: 3 },
  margin: { chips: 3, falling: 3 },
  wide: { chips: 3, falling: 3, warns: 'as wide as its stage' },
  high: { chips: 3, falling: 3, warns: 'larger than it' },
  large: { chips: 3, falling: 3, warns: 'larger than it' },
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

for (const kind of ['zero', 'flat', 'undisplayed', 'absolute', 'image']) {
  test(`a child of the kind "${kind}" falls as soon as it has a size`, async ({ stage }) => {
    await stage.settled('inputs', { children: kind })
    const chip = stage.chips.nth(1)
    await expect(chip).toHaveAttribute('data-state', 'waiting')
    await chip.evaluate((wrapper) => {
      const child = wrapper.firstElementChild as HTMLElement
      child.className = ''
      child.style.cssText = 'display: block; width: 50px; height: 30px'
    })
    await expect(chip).toHaveAttribute('data-state', 'falling')
    await stage.reaches('resting')
    expect(new Set(await stage.states())).toEqual(new Set(['resting']))
    expect(await stage.overlap()).toBeLessThan(1)
  })
}

for (const kind of ['wide', 'high', 'large']) {
  test(`a child of the kind "${kind}", larger than the stage, comes down into it and lies on something`, async ({
    stage,
  }) => {
    await stage.settled('inputs', { children: kind })
    const { shapes, poses, stage: size } = await stage.pile()
    const { y, angle } = poses[1]
    const reach = shapes[1].width * Math.abs(Math.sin(angle)) + shapes[1].height * Math.abs(Math.cos(angle))
    // Its lower edge is no higher than two chips over the floor.
    expect(y + reach / 2).toBeGreaterThan(size.height - 90)
    expect(await stage.hovering()).toBeLessThan(0.5)
  })
}
