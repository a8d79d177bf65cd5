import { expect, StagePage, test } from './fixtures/stage'

/**
 * Values that nobody should give a prop. Each has a stage on the page: its name, and how a warning writes it.
 */
async function open(stage: StagePage, prop: string) {
  await stage.open('values', { prop })
  const all = await stage.page.locator('[data-value]').all()
  expect(all).toHaveLength(12)
  return Promise.all(
    all.map(async (box) => ({
      value: (await box.getAttribute('data-value'))!,
      text: (await box.getAttribute('data-written'))!,
      one: new StagePage(stage.page, box.locator('[data-slot=gravity-stack]')),
    })),
  )
}

/** What a developer was told of a prop with the value that is written so. */
async function told(stage: StagePage, prop: string, text: string) {
  const warnings = await stage.probe((probe) => probe.warnings)
  return warnings.find((warning) => warning.startsWith(`GravityStack: ${prop} is ${text}, `))
}

async function expectPile(one: StagePage, value: string) {
  await one.reaches('resting')
  expect(new Set(await one.states()), value).toEqual(new Set(['resting']))
  expect(await one.overlap(), value).toBeLessThan(1)
}

for (const prop of ['gravity', 'bounce', 'stagger', 'friction']) {
  test(`whatever ${prop} is given, the chips fall and rest, and a developer is told why`, async ({
    stage,
  }) => {
    const stages = await open(stage, prop)
    // A minute between releases, at most.
    for (const { value, one } of stages)
      if (prop === 'stagger' && value === 'huge')
        await expect(one.chips.first()).toHaveAttribute('data-state', 'resting')
      else await expectPile(one, value)
    expect(await stage.probe((probe) => probe.warnings)).toHaveLength(stages.length)
    // What is wrong, what becomes of it, and what to do.
    for (const { text } of stages)
      expect(await told(stage, prop, text)).toMatch(
        new RegExp(`, which .+, so .+ stands in for it\\. Pass .+ or leave ${prop} out\\.`),
      )
  })
}

test('whatever interactive is given counts as true or false, and a developer is told which', async ({
  stage,
}) => {
  const off = ['nan', 'null', 'false']
  for (const { value, text, one } of await open(stage, 'interactive')) {
    await expectPile(one, value)
    const cursor = await one.chips.first().evaluate((chip) => getComputedStyle(chip).cursor)
    expect(cursor, value).toBe(off.includes(value) ? 'auto' : 'grab')
    const warning = await told(stage, 'interactive', text)
    if (value === 'false') expect(warning).toBeUndefined()
    else expect(warning).toContain(`, so it counts as ${!off.includes(value)}. Pass true or false.`)
  }
})

test('whatever upright is given counts as true or false, and a developer is told which', async ({
  stage,
}) => {
  const off = ['nan', 'null', 'false']
  for (const { value, text, one } of await open(stage, 'upright')) {
    await expectPile(one, value)
    const warning = await told(stage, 'upright', text)
    if (value === 'false') expect(warning).toBeUndefined()
    else expect(warning).toContain(`, so it counts as ${!off.includes(value)}. Pass true or false.`)
  }
})

test('an onSettle that can’t be called is not, and a developer is told so', async ({ stage }) => {
  const stages = await open(stage, 'onSettle')
  for (const { value, one } of stages) await expectPile(one, value)
  // null, NaN and false are common ways to leave it out.
  const wrong = stages.filter(({ value }) => !['null', 'nan', 'false'].includes(value))
  expect(await stage.probe((probe) => probe.warnings)).toHaveLength(wrong.length)
  for (const { text } of wrong)
    expect(await told(stage, 'onSettle', text)).toContain(', so nothing is called. Pass a function')
})

test('whatever className is given, the chips fall and rest', async ({ stage }) => {
  for (const { value, one } of await open(stage, 'className')) await expectPile(one, value)
})

/** Children that nobody should write, and how many chips each makes with the two beside it. */
const unremarkable = {
  none: 2,
  null: 2,
  false: 2,
  number: 3,
  empty: 2,
  blanks: 3,
  array: 4,
  fragment: 4,
  deaf: 3,
  restless: 3,
  inline: 3,
  contents: 3,
  margin: 3,
  tiny: 3,
  ellipse: 3,
}

test('children of any kind make chips, or none, that fall and rest; those beside them can go and come back', async ({
  stage,
  page,
}) => {
  await stage.open('inputs', { children: Object.keys(unremarkable).join(' ') })
  const kinds = Object.entries(unremarkable).map(([kind, chips]) => ({
    chips,
    one: new StagePage(page, page.locator(`[data-kind=${kind}] [data-slot=gravity-stack]`)),
  }))
  for (const round of ['come', 'gone', 'come back']) {
    if (round !== 'come') await page.locator('#toggle').click()
    for (const { chips, one } of kinds) {
      await expect(one.chips).toHaveCount(round === 'gone' ? chips - 1 : chips)
      await one.reaches('resting')
      expect(new Set(await one.states())).toEqual(new Set(['resting']))
      expect(await one.overlap()).toBeLessThan(1)
    }
  }
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.warnings)).toEqual([])
})

test('a margin of a chip is no part of what collides', async ({ stage }) => {
  await stage.settled('inputs', { children: 'margin' })
  const sizes = await stage.chip('margin').evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    return [chip.clientWidth - face.offsetWidth, chip.clientHeight - face.offsetHeight]
  })
  expect(sizes).toEqual([0, 0])
})

for (const react of ['18', '19']) {
  test(`React ${react} asks for the keys of a list of chips that has none, and for no others`, async ({
    stage,
  }) => {
    const told = () => stage.probe((probe) => probe.errors.splice(0))
    await stage.settled('inputs', { react, children: 'array fragment number blanks' })
    expect(await told()).toEqual([])
    await stage.settled('inputs', { react, children: 'unkeyed' })
    expect((await told()).join()).toContain('should have a unique "key" prop')
  })
}

for (const kind of ['component', 'portal', 'zero', 'flat', 'undisplayed', 'absolute', 'image']) {
  test(`a child of the kind "${kind}", which has no size, waits until it has one and does no harm to the others`, async ({
    stage,
    page,
  }) => {
    await stage.settled('inputs', { children: kind })
    expect(await stage.states()).toEqual(['resting', 'waiting', 'resting'])
    expect((await stage.probe((probe) => probe.warnings)).join()).toContain('no size')
    await page.locator('#toggle').click()
    await expect(stage.chips).toHaveCount(2)
    await page.locator('#toggle').click()
    await stage.reaches('running')
    await stage.reaches('resting')
    expect(await stage.during('frames')).toBe(0)
    const chip = stage.chips.nth(1)
    await chip.evaluate((wrapper) => {
      const child = wrapper.firstElementChild as HTMLElement | null
      if (!child) return wrapper.append(Object.assign(document.createElement('p'), { textContent: 'late' }))
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
    page,
  }) => {
    await stage.settled('inputs', { children: kind })
    expect((await stage.probe((probe) => probe.warnings)).join()).toContain('larger than it')
    const { shapes, poses, stage: size } = await stage.pile()
    const { y, angle } = poses[1]
    const reach = shapes[1].width * Math.abs(Math.sin(angle)) + shapes[1].height * Math.abs(Math.cos(angle))
    // Its lower edge is no higher than two chips over the floor.
    expect(y + reach / 2).toBeGreaterThan(size.height - 90)
    expect(await stage.hovering()).toBeLessThan(0.5)
    await page.locator('#toggle').click()
    await page.locator('#toggle').click()
    await stage.reaches('running')
    await stage.reaches('resting')
    expect(await stage.during('frames')).toBe(0)
  })
}
