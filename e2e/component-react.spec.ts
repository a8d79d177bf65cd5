import { expect, test } from './fixtures/stage'

for (const react of ['18', '19']) {
  test.describe(`React ${react}`, () => {
    test('server markup is hydrated in StrictMode without a word, and the chips fall once', async ({
      stage,
    }) => {
      await stage.settled('pile', { react, chips: 6 })
      expect(await stage.overlap()).toBeLessThan(1)
      expect(await stage.probe(({ errors, warnings }) => [...errors, ...warnings])).toEqual([])
      // StrictMode mounts twice: the first stage leaves everything as it was rendered.
      expect(await stage.probe((probe) => probe.states)).toEqual(['static', 'waiting', 'running', 'resting'])
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
