import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { chipDistance, stageDistance, worstOverlap } from '../scenes/exact-distance'
import { expect, type StagePage, test } from './fixtures/stage'

/** Where each chip lies, by its text. */
async function places(stage: StagePage) {
  const texts = await stage.chips.allInnerTexts()
  const { poses } = await stage.pile()
  return new Map(texts.map((text, i) => [text, poses[i]]))
}

const far = (a: { x: number; y: number }, b: { x: number; y: number }) => Math.hypot(a.x - b.x, a.y - b.y)

const additions = [
  ['in front', '#first', 0],
  ['behind others', '#add', 8],
] as const

for (const [where, button, at] of additions) {
  test(`a child added ${where} drops in; the drop of the others does not start again`, async ({
    stage,
    page,
  }) => {
    await stage.settled('children')
    const before = await places(stage)
    await stage.probe((probe) => [probe.states.splice(0), probe.releases.splice(0)])
    await page.locator(button).click()
    await stage.reaches('running')
    await stage.reaches('resting')
    const after = await places(stage)
    const added = [...after.keys()][at]
    expect([...after.keys()]).toEqual([...before.keys()].toSpliced(at, 0, added))
    const stayed = [...before].filter(([text, pose]) => far(pose, after.get(text)!) < 3)
    expect(stayed.length).toBeGreaterThan(7)
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.hovering()).toBeLessThan(0.5)
    expect(await stage.probe((probe) => probe.states)).toEqual(['running', 'resting'])
    expect(await stage.probe((probe) => probe.releases)).toEqual([[at, 0]])
    // Those who were there can be grabbed as before.
    await stage.drag(stage.chip('two'), 5, -60)
    await expect(stage.chip('two')).toHaveAttribute('data-state', 'held')
    await page.mouse.up()
  })
}

test('children that come together later fall one by one as well', async ({ stage, page }) => {
  await stage.settled('children')
  await stage.probe((probe) => probe.releases.splice(0))
  await page.locator('#add').evaluate((button: HTMLElement) => {
    for (let i = 0; i < 4; i++) button.click()
  })
  await expect(stage.chips).toHaveCount(15)
  await expect.poll(() => stage.states()).not.toContain('waiting')
  const left = await stage.probe((probe) => probe.releases.map(([, waiting]) => waiting))
  expect(Math.max(...left)).toBeGreaterThan(1)
})

test('a new order and a render without change leave the pile as it lies', async ({ stage, page }) => {
  await stage.settled('children')
  const before = await places(stage)
  const texts = [...before.keys()]
  await page.locator('#reverse').click()
  await expect(stage.chips).toHaveText([...texts.slice(0, 8).toReversed(), ...texts.slice(8)])
  await page.locator('#rerender').click()
  await expect(stage.root).toHaveAttribute('data-count', '1')
  await stage.reaches('resting')
  expect(await places(stage)).toEqual(before)
})

test('a removed child vanishes, what it carried falls, the rest stay where they are', async ({
  stage,
  page,
}) => {
  await stage.settled('children')
  const before = await places(stage)
  // One of those that can be removed and that carries another.
  const texts = await stage.chips.allInnerTexts()
  const { shapes, poses, stage: room } = await stage.pile()
  const carries = (i: number) =>
    poses.some(
      (pose, j) =>
        i !== j &&
        pose.y < poses[i].y - 10 &&
        chipDistance(shapes[i], poses[i], shapes[j], pose) < 0.5 &&
        stageDistance(shapes[j], pose, room).floor > 5,
    )
  const carrier = texts.findIndex((text, i) => !/fragment|text/.test(text) && carries(i))
  expect(carrier).toBeGreaterThanOrEqual(0)
  await page.evaluate((name) => window.remove(name), texts[carrier])
  await stage.reaches('running')
  await stage.reaches('resting')
  const after = await places(stage)
  expect([...after.keys()]).toEqual(texts.filter((_, i) => i !== carrier))
  const stayed = [...after].filter(([text, pose]) => far(pose, before.get(text)!) < 3)
  expect(stayed.length).toBeGreaterThan(3)
  expect(stayed.length).toBeLessThan(10)
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
})

for (const what of ['hidden', 'taken away']) {
  test(`when chips that wait are ${what}, those behind them move up`, async ({ stage }) => {
    // Behind twenty others the last would come after 105 s, and no state is waited for as long.
    await stage.open('pile', { chips: 22, stagger: 5000 })
    await stage.reaches('running')
    await stage.chips.evaluateAll((all, what) => {
      for (const chip of all.slice(1, -1)) {
        if (what === 'hidden') (chip.firstElementChild as HTMLElement).style.display = 'none'
        else chip.remove()
      }
    }, what)
    await expect(stage.chips.last()).toHaveAttribute('data-state', 'resting')
    await stage.reaches('resting')
  })
}

test('conditional children and fragments come and go one by one', async ({ stage, page }) => {
  await stage.settled('children')
  await page.locator('#extra').click()
  await expect(stage.chips).toHaveCount(13)
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.chips.allInnerTexts()).toEqual(expect.arrayContaining(['conditional', 'nested']))
  await page.locator('#extra').click()
  await expect(stage.chips).toHaveCount(11)
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a chip that comes later is seen nowhere before it comes in from above', async ({ stage, page }) => {
  await stage.settled('children')
  const bottoms = await page.evaluate(async () => {
    const root = document.querySelector('[data-slot=gravity-stack]')!
    const known = [...root.children]
    document.querySelector<HTMLElement>('#extra')!.click()
    const found: number[] = []
    while (found.length < 2) {
      await window.probe.pass(1)
      for (const chip of root.children) {
        if (known.includes(chip) || chip.getAttribute('data-state') === 'waiting') continue
        known.push(chip)
        found.push(chip.getBoundingClientRect().bottom - root.getBoundingClientRect().top)
      }
    }
    return found
  })
  for (const bottom of bottoms) expect(bottom).toBeLessThan(0)
})

/** Runs `change` in the page until the pile rests again. Returns the farthest that any chip got away, px. */
async function farthestWay(stage: StagePage, change: string) {
  await stage.probe((probe) => probe.states.splice(0))
  return stage.page.evaluate(async (change) => {
    const chips = [...document.querySelectorAll('[data-slot=gravity-stack-chip]')]
    const centres = () =>
      chips.map((chip) => {
        const { x, y, width, height } = chip.getBoundingClientRect()
        return { x: x + width / 2, y: y + height / 2 }
      })
    const start = centres()
    let most = 0
    // biome-ignore lint/security/noGlobalEval: it is a test's own
    await eval(change)
    while (window.probe.states.at(-1) !== 'resting') {
      await window.probe.pass(1)
      for (const [i, { x, y }] of centres().entries())
        most = Math.max(most, Math.hypot(x - start[i].x, y - start[i].y))
    }
    return most
  }, change)
}

const changes = {
  'is given a width': "document.getElementById('grow').click()",
  'gets a longer word': "document.getElementById('longer').click()",
}

for (const [what, change] of Object.entries(changes)) {
  test(`a chip that ${what} becomes its new shape in place and pushes its neighbours off gently`, async ({
    stage,
  }) => {
    await stage.settled('children')
    const width = async () => (await stage.pile()).shapes[1].width
    const before = await width()
    const farthest = await farthestWay(stage, change)
    const growth = (await width()) - before
    expect(growth).toBeGreaterThan(80)
    expect(farthest).toBeLessThan(growth)
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.hovering()).toBeLessThan(0.5)
    expect(await stage.outside()).toBeLessThan(1)
    expect(await stage.during('frames')).toBe(0)
  })
}

test('a font that arrives late widens the chips where they lie, and the pile takes it in place', async ({
  stage,
  page,
}) => {
  const file = '@fontsource-variable/geist-mono/files/geist-mono-latin-wght-normal.woff2'
  const font = readFileSync(createRequire(import.meta.url).resolve(file), 'base64')
  await stage.open('children')
  await page.addStyleTag({ content: '[data-slot=gravity-stack] { font-family: Late, serif }' })
  await stage.reaches('resting')
  const before = await stage.pile()
  const url = `url(data:font/woff2;base64,${font})`
  const farthest = await farthestWay(
    stage,
    `new FontFace('Late', '${url}').load().then((face) => void document.fonts.add(face))`,
  )
  const after = await stage.pile()
  const growth = after.shapes.map(({ width }, i) => width - before.shapes[i].width)
  expect(Math.min(...growth)).toBeGreaterThan(1)
  expect(farthest).toBeGreaterThan(1)
  expect(farthest).toBeLessThan(growth.reduce((sum, px) => sum + px) / 2)
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
  expect(await stage.probe((probe) => probe.states)).toEqual(['running', 'resting'])
  expect(await stage.during('frames')).toBe(0)
})

test('a chip that loses its round corners stands like a box', async ({ stage, page }) => {
  await stage.settled('children')
  await page.locator('#square').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('chips that lose their round corners while they wait fall as boxes', async ({ stage }) => {
  await stage.open('pile', { chips: 16, stagger: 100 })
  await stage.reaches('running')
  await stage.chips.evaluateAll((all) => {
    for (const chip of all) (chip.firstElementChild as HTMLElement).style.borderRadius = '0'
  })
  expect(await stage.states()).toContain('waiting')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('corners that a script squares in the chip’s own style alone count at once', async ({ stage }) => {
  await stage.settled('children')
  const mutations = () => stage.probe((probe) => probe.mutations)
  const before = await mutations()
  await stage.chip('three').evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    face.style.borderRadius = '0'
  })
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  // Neither the way to the new rest nor anything else that the stage itself writes has woken its observer
  // again.
  expect((await mutations()) - before).toBe(1)
  // The face of a chip may be another element by and by.
  await stage.chip('three').evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    face.replaceWith(face.cloneNode(true))
  })
  await expect.poll(mutations).toBe(before + 2)
  await stage.chip('three').evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    face.style.borderRadius = '99px'
  })
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a picture that comes late falls once it has a size', async ({ stage, page }) => {
  await stage.settled('children')
  await page.locator('#picture').click()
  await expect(stage.chips).toHaveCount(12)
  await page.evaluate(() => window.probe.pass(5))
  const picture = stage.chips.filter({ has: page.locator('img') })
  await expect(picture).toHaveAttribute('data-state', 'waiting')
  await page.locator('#load').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a text that comes in front of others is a chip of its own, and theirs stay theirs', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'texts' })
  const marked = () =>
    stage.chips.evaluateAll((all) =>
      all.map((chip) => `${chip.textContent} ${(chip as HTMLElement).dataset.mark ?? ''}`.trim()),
    )
  await stage.chips.evaluateAll((all) => {
    for (const chip of all) (chip as HTMLElement).dataset.mark = chip.textContent!
  })
  await page.locator('#next').click()
  await expect.poll(marked).toEqual(['first', 'second second', 'third third'])
  await stage.reaches('resting')
  await page.locator('#next').click()
  await expect.poll(marked).toEqual(['second second', 'third third'])
})

for (const react of ['18', '19'])
  test(`on a translated page chips of mere words keep the corners that a rule gives them, and show words that change (React ${react})`, async ({
    stage,
    page,
  }) => {
    await stage.settled('surroundings', { kind: 'words', react })
    // As browsers do it: each text gives way to elements of theirs, with another text in them.
    const translate = () =>
      stage.chips.evaluateAll((all) => {
        for (const chip of all)
          for (const text of [...chip.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE)) {
            const inner = document.createElement('font')
            inner.textContent = `${text.textContent} translated`
            const outer = document.createElement('font')
            outer.append(inner)
            text.replaceWith(outer)
          }
      })
    const corners = () =>
      stage.chips.evaluateAll((all) => all.map((chip) => getComputedStyle(chip).borderRadius))
    await translate()
    await expect(stage.chips).toHaveText(['word translated', '1 translated', 'same translated'])
    await stage.reaches('running')
    await stage.reaches('resting')
    expect(await corners()).toEqual(Array(3).fill('10px'))
    const { shapes, poses, stage: room } = await stage.pile()
    const drawn = shapes.map((shape) => ({ ...shape, radius: 10 }))
    expect(worstOverlap(drawn, poses, room)).toBeLessThan(1)

    await page.locator('#next').click()
    await expect(stage.chips).toHaveText(['a longer word', '2', 'same translated'])
    await translate()
    await stage.reaches('resting')
    expect(await corners()).toEqual(Array(3).fill('10px'))
  })

test('drop() goes by the order of the children, not by when they came', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'front' })
  await page.locator('#next').click()
  await expect(stage.chips.first()).toHaveText('new')
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.locator('#drop').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  const order = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(order.slice(-4)).toEqual([0, 1, 2, 3])
})

test('what a portal among the chips shows keeps what was typed there when a chip comes before it', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'portal' })
  await page.getByLabel('elsewhere').fill('typed')
  await page.locator('#next').click()
  await expect(stage.chip('new')).toHaveAttribute('data-state', 'falling')
  await expect(page.getByLabel('elsewhere')).toHaveValue('typed')
})
