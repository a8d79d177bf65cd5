import { readFileSync } from 'node:fs'
import { test as early, expect } from '@playwright/test'
import type { Results } from '../bench/publish/report'
import { figure } from '../lib/figure'
import { test, withhold } from './page'

test.describe('benchmarks', () => {
  test('every plot has its figures as a table', async ({ page }) => {
    await page.goto('/benchmarks')
    const figures = page.locator('figure').filter({ has: page.locator('summary') })
    expect(await figures.count()).toBeGreaterThan(20)
    const open = () =>
      figures.evaluateAll((all) =>
        all.map((figure) => {
          const details = figure.querySelector('details')!
          details.open = true
          const plot = figure.querySelector('svg[role=img] > title')?.textContent ?? ''
          const table = details.querySelector('[role=region]')
          return {
            plot: /both logarithmic/.test(plot),
            table: plot.startsWith(`${table?.getAttribute('aria-label')}: `),
            rows: (table?.querySelectorAll('tbody tr').length ?? 0) > 2,
          }
        }),
      )
    const both = Array(await figures.count()).fill({ plot: true, table: true, rows: true })
    await expect.poll(open).toEqual(both)
    await expect(figures.last().getByRole('row').nth(3)).toBeVisible()
    // On a phone too, no power of ten is torn from its digits.
    await page.setViewportSize({ width: 375, height: 700 })
    const lines = await figures.locator('td', { hasText: '·' }).evaluateAll((cells) =>
      cells.map((cell) => {
        const range = document.createRange()
        range.selectNodeContents(cell)
        return range.getClientRects().length
      }),
    )
    expect(lines.length).toBeGreaterThan(20)
    expect(new Set(lines)).toEqual(new Set([1]))
  })

  test('no table is cut off on a laptop', async ({ page }) => {
    await page.setViewportSize({ width: 1280, height: 800 })
    await page.goto('/benchmarks')
    const cut = await page
      .getByRole('region')
      .evaluateAll((all) =>
        all.flatMap((table) => (table.scrollWidth > table.clientWidth ? [table.ariaLabel] : [])),
      )
    expect(cut).toEqual([])
  })

  for (const { width, height } of [
    { width: 1440, height: 900 },
    { width: 375, height: 700 },
  ]) {
    test(`the legend is in sight wherever a plot is, ${width} px wide`, async ({ page }) => {
      await page.setViewportSize({ width, height })
      await page.goto('/benchmarks#pours')
      const legend = page.getByRole('group', { name: 'Show one engine beside ours' })
      const heading = page.getByRole('heading', { name: 'Pours', exact: true })
      await expect(heading).toBeInViewport()
      const bottom = async (part: typeof legend) => {
        const { y, height } = (await part.boundingBox())!
        return y + height
      }
      expect((await heading.boundingBox())!.y).toBeGreaterThan(await bottom(legend))
      expect((await legend.boundingBox())!.y).toBeGreaterThan((await bottom(page.getByRole('banner'))) - 2)
      await legend.getByText('Planck').click()
      await expect(page.locator('figure svg [data-engine=matter-js]').first()).toHaveCSS('opacity', '0.12')
    })
  }

  test('“On this page” leads to every part', async ({ page }) => {
    await page.goto('/benchmarks')
    const links = page.getByRole('navigation', { name: 'On this page' }).getByRole('link')
    const headings = page.locator('main').locator('h2, h3')
    expect(await links.allInnerTexts()).toEqual(
      await headings.evaluateAll((all) =>
        all.map((heading) => heading.querySelector('a')!.firstChild!.textContent),
      ),
    )
    await links.filter({ hasText: 'Who is cheaper' }).click()
    await expect(page).toHaveURL(/#cheaper$/)
    await expect(page.getByRole('heading', { name: 'Who is cheaper' })).toBeInViewport()
  })

  test('rows of the costs carry the marks of the plot beside them', async ({ page }) => {
    await page.goto('/benchmarks')
    const rows = page.getByRole('region', { name: /^Cost by number of chips/ }).locator('tbody tr')
    expect(await rows.count()).toBeGreaterThan(8)
    await expect(rows.locator('th svg path')).toHaveCount(await rows.count())
  })

  test('each row of the claim that does not hold is an exception with a name', async ({ page }) => {
    await page.goto('/benchmarks')
    const section = page.locator('section', { has: page.locator('h2#claim') })
    const verdicts = await section.locator('tbody td:last-child').allInnerTexts()
    expect(verdicts.length).toBeGreaterThan(20)
    for (const verdict of verdicts) expect(verdict).toMatch(/^(ours$|tie: \S|not ours: \S)/)
    const lost = verdicts.filter((verdict) => verdict.startsWith('not ours')).length
    const outright = verdicts.filter((verdict) => verdict === 'ours').length
    await expect(section.getByText(`In ${outright} of the ${verdicts.length} rows`)).toBeVisible()
    // Where a cheaper engine errs less by what doesn't count, the row says so.
    for (const row of await section.locator('tbody tr', { hasText: 'tie: ' }).all()) {
      await expect(row).toContainText('both below 10')
    }
    await expect(section.getByRole('listitem')).toHaveCount(lost)
    for (const exception of await section.getByRole('listitem').all()) {
      await expect(exception).toContainText(/at .+: .+ × the cost, .+ × the error/)
    }
  })

  test('one engine can be picked out with the keyboard', async ({ page }) => {
    await page.goto('/benchmarks')
    const marks = (engine: string) => page.locator(`figure svg [data-engine=${engine}]`).first()
    await page.getByRole('radio', { name: 'All' }).focus()
    await page.getByRole('radio', { name: /^Rapier \d/ }).press('Space')
    await expect(marks('rapier')).toHaveCSS('opacity', '1')
    await expect(marks('box2d3-wasm-simd')).toHaveCSS('opacity', '0.12')
    await expect(marks('gravity-stack')).toHaveCSS('opacity', '1')
  })

  test('ours can be picked out alone, and no two engines share a mark', async ({ page }) => {
    await page.goto('/benchmarks')
    const legend = page.getByRole('group', { name: 'Show one engine beside ours' })
    await legend.getByText('Gravity Stack').click()
    const marks = (engine: string) => page.locator(`figure svg [data-engine=${engine}]`).first()
    await expect(marks('gravity-stack')).toHaveCSS('opacity', '1')
    await expect(marks('rapier')).toHaveCSS('opacity', '0.12')
    const inFront = page.locator('figure svg [data-engine]:last-of-type')
    for (const engine of await inFront.all())
      await expect(engine).toHaveAttribute('data-engine', 'gravity-stack')
    // Without their colours: outline, and whether it is filled.
    const shapes = await legend
      .locator('svg path')
      .evaluateAll((all) =>
        all.map((mark) => mark.getAttribute('d')! + /panel/.test(mark.getAttribute('fill')!)),
      )
    expect(shapes.length).toBe(10)
    expect(new Set(shapes).size).toBe(shapes.length)
  })

  test('what a browser takes is in a table with its date', async ({ page, request }) => {
    const file = 'bench/results/browser.json'
    await page.goto('/benchmarks')
    const section = page.locator('section', { has: page.locator('h2#browser') })
    const { date, stages } = JSON.parse(readFileSync(file, 'utf8'))
    const table = section.getByRole('region', { name: 'In a browser' })
    await expect(table.getByRole('row')).toHaveCount(21)
    await expect(table.getByRole('columnheader')).toHaveCount(2 + Object.keys(stages).length)
    await expect(table).not.toContainText(/NaN|undefined/)
    await expect(section.locator('time')).toHaveAttribute('datetime', date)
    expect((await request.get('/benchmarks/browser.json')).ok()).toBe(true)
  })

  test('the raw data is there to take', async ({ request }) => {
    const response = await request.get('/benchmarks/errors.csv')
    expect(response.ok()).toBe(true)
    expect(await response.text()).toBe(readFileSync('bench/results/errors.csv', 'utf8'))
  })

  test('a run that can not go on says so and why, and can be tried again', async ({ page }) => {
    // A worker takes what it may do from the answer that its script came with: here no WebAssembly.
    await page.route('**/*.js', async (route) => {
      const response = await route.fetch()
      const headers = { ...response.headers(), 'content-security-policy': "script-src 'self'" }
      await route.fulfill({ response, headers })
    })
    await page.goto('/benchmarks')
    await page.getByRole('button', { name: 'Run on this device' }).click()
    const said = page.getByRole('status').filter({ hasText: 'It stopped.' })
    await expect(said).toContainText('WebAssembly', { timeout: 150_000 })
    await expect(page.getByRole('button', { name: 'Run again' })).toBeVisible()

    await page.evaluate(() => {
      window.Worker = class {
        constructor() {
          throw new Error('no workers here')
        }
      } as unknown as typeof Worker
    })
    await page.getByRole('button', { name: 'Run again' }).click()
    await expect(said).toContainText('no workers here')
  })

  test('a visitor can run it, stop it and run it again; all are warm before one is timed, and take turns', async ({
    page,
  }) => {
    // Ninety pours, one after the other: minutes on a slow machine that other tests share.
    test.setTimeout(400_000)
    await page.addInitScript(() => {
      const news: string[] = []
      Object.assign(window, { news })
      window.Worker = class extends Worker {
        constructor(...of: ConstructorParameters<typeof Worker>) {
          super(...of)
          news.length = 0
          this.addEventListener('message', ({ data }) => news.push(data.engine ?? data.kind))
        }
      }
    })
    await page.goto('/benchmarks')
    await page.getByRole('button', { name: 'Run on this device' }).click()
    await expect(page.getByRole('progressbar', { name: 'Benchmark' })).toBeVisible()
    await page.getByRole('button', { name: 'Cancel' }).click()
    await expect(page.getByRole('progressbar', { name: 'Benchmark' })).toBeHidden()
    await page.getByRole('button', { name: /^Run/ }).click()
    await expect(page.getByRole('status').filter({ hasText: 'Done.' })).toBeVisible({ timeout: 300_000 })
    const table = page.getByRole('region', { name: 'Results of this device' })
    await expect(table.getByRole('row')).toHaveCount(7)
    const news = await page.evaluate(() => (window as unknown as { news: string[] }).news)
    const turn = ['gravity-stack', 'gravity-stack', 'matter-js', 'matter-js', 'rapier', 'rapier']
    const runs = Array(3).fill('gravity-stack')
    expect(news.slice(0, news.indexOf('point'))).toEqual([...Array(12).fill(turn).flat(), ...runs])
  })
})

test('another run begins with an empty table, and one whose script does not come says so', async ({
  page,
}) => {
  await page.addInitScript(() => {
    let runs = 0
    window.Worker = class {
      onmessage?: (event: unknown) => void
      onerror?: (event: unknown) => void
      constructor() {
        const say = (data: object) => this.onmessage!({ data })
        const point = { engine: 'gravity-stack', setting: {}, cost: 1, rest: 0.01, during: 0.1 }
        setTimeout(() => {
          if (++runs > 2) return this.onerror!({ message: '' })
          say({ kind: 'point', point })
          say({ kind: 'done' })
        })
      }
      terminate() {}
    } as unknown as typeof Worker
  })
  await page.goto('/benchmarks')
  const status = page.getByRole('status')
  const rows = page.getByRole('region', { name: 'Results of this device' }).locator('tbody tr')
  for (const name of ['Run on this device', 'Run again']) {
    await page.getByRole('button', { name }).click()
    await expect(status.filter({ hasText: 'Done.' })).toBeVisible()
    await expect(rows).toHaveCount(1)
  }
  await page.getByRole('button', { name: 'Run again' }).click()
  await expect(status.filter({ hasText: 'It stopped. the worker could not be loaded' })).toBeVisible()
  await expect(rows).toHaveCount(0)
})

early('figures that are opened before the script is there come with it', async ({ page }) => {
  const letCome = await withhold(page, '**/*.js')
  await page.goto('/benchmarks', { waitUntil: 'commit' })
  const figure = page
    .locator('figure')
    .filter({ has: page.locator('summary') })
    .first()
  await figure.locator('summary').click()
  await expect(figure.getByRole('link', { name: 'errors.csv' })).toBeVisible()
  letCome()
  await expect(figure.getByRole('row').nth(3)).toBeVisible()
})

test('figures that could not be fetched are asked for again with the next table', async ({ page }) => {
  await page.goto('/benchmarks')
  const opened = page.locator('figure details')
  await page.route('**/figures.json', (route) => route.fulfill({ status: 503, body: '' }))
  await opened.nth(0).locator('summary').click()
  await expect(opened.nth(0).getByRole('alert')).toContainText('could not be fetched')
  await page.unroute('**/figures.json')
  await opened.nth(1).locator('summary').click()
  await expect(opened.nth(1).getByRole('row').nth(3)).toBeVisible()
  await expect(opened.nth(1).getByText('(frontier)').first()).toBeVisible()
})

test('each table of figures says of which plot it is before it is opened', async ({ page }) => {
  await page.goto('/benchmarks')
  const names = await page.locator('figure summary').allTextContents()
  expect(names.length).toBeGreaterThan(20)
  expect(new Set(names).size).toBe(names.length)
})

test('goals missed in a browser are said to be missed, and no others', async ({ page }) => {
  await page.goto('/benchmarks')
  const table = page.getByRole('region', { name: 'In a browser' })
  await expect(table.getByRole('row', { name: /^Script of the stage/ })).toContainText('missed')
  await expect(table.getByRole('row', { name: /^Layouts to bring/ })).not.toContainText('missed')
})

test('the tables of costs and bytes have the figures of the raw data', async ({ page }) => {
  const { pourCosts, bytes }: Results = JSON.parse(readFileSync('bench/results/results.json', 'utf8'))
  await page.goto('/benchmarks')
  const cost = (engine: string, chips: number) =>
    pourCosts.find((row) => row.engine === engine && row.chips === chips)!.cost!.mean
  const costs = page.getByRole('region', { name: /^Cost by number of chips/ }).getByRole('row')
  await expect(costs.filter({ hasText: 'Gravity Stack' }).getByRole('cell')).toHaveText(
    [12, 60, 250, 1000, 4000].map((chips) => figure(cost('gravity-stack', chips))),
  )
  const simd = costs.filter({ hasText: 'wasm with SIMD' })
  const share = figure(cost('box2d3-wasm-simd', 60) / cost('gravity-stack', 60))
  await expect(simd.getByRole('cell').nth(1)).toHaveText(
    `${figure(cost('box2d3-wasm-simd', 60))} (${share} ×)`,
  )
  await expect(page.getByRole('region', { name: 'Who is cheaper' }).getByRole('row').nth(2)).toContainText(
    `wasm with SIMD ${share}`,
  )
  const weights = page.getByRole('region', { name: 'Bytes, allocation and sleep' }).getByRole('row')
  await expect(weights.filter({ hasText: 'Matter' }).getByRole('cell').first()).toHaveText(
    (bytes.find(({ name }) => name === 'matter-js')!.gzip / 1000).toFixed(1),
  )
  await expect(page.getByRole('region', { name: 'Sixty pills, all properties' })).toContainText('not in 6 s')
  await expect(page.locator('figure svg path[stroke-dasharray]')).not.toHaveCount(0)
})

test('a line joins those settings of an engine that none of its own beats', async ({ page }) => {
  await page.goto('/benchmarks')
  const plots = page.locator('figure svg', { hasText: 'error, ' })
  const lines = await plots
    .locator('[data-engine] > path:first-of-type')
    .evaluateAll((all) =>
      all.map((line) => [...line.getAttribute('d')!.matchAll(/ ([\d.]+)/g)].map(([, y]) => Number(y))),
    )
  expect(lines.length).toBeGreaterThan(100)
  // Ever dearer, and ever more exact: further down.
  for (const line of lines) expect(line).toEqual([...line].sort((a, b) => a - b))
})

test('errors that are rounding stand on the lowest line, which says so', async ({ page }) => {
  await page.goto('/benchmarks')
  const exact = page.locator('figure svg', { has: page.getByText(/^≤ /) })
  expect(await exact.count()).toBeGreaterThan(5)
  const found = await exact.evaluateAll((plots) =>
    plots.map((plot) => {
      const words = [...plot.querySelectorAll('text')].filter(({ textContent }) => /^≤/.test(textContent!))
      const marks = [...plot.querySelectorAll('[data-engine] path')].flatMap((path) =>
        [...path.getAttribute('d')!.matchAll(/ ([\d.]+)/g)].map(([, y]) => Number(y)),
      )
      // The words stand a little below their line.
      return {
        lines: words.length,
        below: marks.filter((y) => y > Number(words[0].getAttribute('y'))).length,
      }
    }),
  )
  for (const plot of found) expect(plot).toEqual({ lines: 1, below: 0 })
})

test('marks stand where the axes say, dearer to the top and more chips to the right', async ({ page }) => {
  const { pourCosts }: Results = JSON.parse(readFileSync('bench/results/results.json', 'utf8'))
  await page.goto('/benchmarks')
  const plot = page.locator('figure svg').filter({ hasText: 'Cost by number of chips' })
  const texts = await plot
    .locator('text')
    .evaluateAll((all) => all.map((e) => [e.textContent!, e.getAttribute('x'), e.getAttribute('y')]))
  const at = (label: string, place: number) => Number(texts.find(([text]) => text === label)![place])
  const across = (chips: number) => {
    const [from, to] = [at('100', 1), at('1,000', 1)]
    return from + (to - from) * Math.log10(chips / 100)
  }
  const [path] = await plot
    .locator('[data-engine=gravity-stack] path')
    .evaluateAll((all) => all.map((e) => e.getAttribute('d')!.slice(1).split('L')))
  const marks = path.map((mark) => mark.split(' ').map(Number))
  const costs = pourCosts.filter(
    ({ engine, setting }) => engine === 'gravity-stack' && Object.keys(setting).length === 0,
  )
  expect(marks).toHaveLength(costs.length)
  const [low, high] = [costs[0], costs[costs.length - 1]].map(({ cost }) => cost!.mean)
  const decade = (marks[0][1] - marks[marks.length - 1][1]) / Math.log10(high / low)
  expect(decade).toBeGreaterThan(0)
  for (const [i, { chips, cost }] of costs.entries()) {
    expect(Math.abs(marks[i][0] - across(chips))).toBeLessThan(0.2)
    expect(Math.abs(marks[0][1] - marks[i][1] - decade * Math.log10(cost!.mean / low))).toBeLessThan(0.2)
  }
})

test('what is said to be on the frontier no other beats, and all of that is said', async ({ request }) => {
  const figures: Record<string, [number, string, number | null, number, 0 | 1][]> = await (
    await request.get('/benchmarks/figures.json')
  ).json()
  for (const [name, rows] of Object.entries(figures)) {
    if (!rows.some((row) => row[4])) continue
    // Figures are rounded, so that two may look alike.
    for (const row of rows) {
      const [, setting, error, cost, best] = row
      const beaten = rows.some(([, , by, at]) => by !== null && by < (error ?? Infinity) && at < cost)
      const met = rows.some(
        (other) => other !== row && other[2] !== null && other[2] <= error! && other[3] <= cost,
      )
      if (best) expect(beaten, `${name} ${setting} ${cost}`).toBe(false)
      else expect(met || error === null, `${name} ${setting} ${cost}`).toBe(true)
    }
  }
})
