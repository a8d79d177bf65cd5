import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { expect, test } from '@playwright/test'
import { build } from 'esbuild'
import { hardScenes } from '../scenes/hard'

// Plays one seed of a scene: the same script in Node and in the page.
const script = build({
  stdin: {
    contents: `
      import { playHard } from './stability/play'
      import { hardScenes } from '../scenes/hard'
      globalThis.playTwin = (name, seed) => {
        const scene = hardScenes.find((scene) => scene.name === name)
        const { figures, hash } = playHard(scene, seed)
        const bound = Object.keys(scene.bounds).map((key) => [key, figures[key].toFixed(6)])
        return { hash, ...Object.fromEntries(bound) }
      }`,
    resolveDir: fileURLToPath(new URL('../bench', import.meta.url)),
    loader: 'ts',
  },
  bundle: true,
  format: 'iife',
  write: false,
}).then(({ outputFiles }) => outputFiles[0].text)

for (const { name, title } of hardScenes) {
  test(`in a browser too, to the last bit: ${title}`, async ({ page }) => {
    const run = `playTwin('${name}', 1)`
    const input = `${await script}; console.log(JSON.stringify(${run}))`
    const inNode = JSON.parse(execFileSync(process.execPath, ['-'], { input, encoding: 'utf8' }))
    await page.addScriptTag({ content: await script })
    expect(await page.evaluate(run)).toEqual(inNode)
  })
}
