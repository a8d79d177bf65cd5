import { execFile } from 'node:child_process'
import { rmSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { rolldown } from 'rolldown'
import type { AtLeast, Cost, Job } from './job'

export const root = dirname(dirname(fileURLToPath(import.meta.url)))

/**
 * Bundles a script of this folder as Vite builds an app. Not with esbuild, which turns the constants of a bundle into variables:
 * the compiler then looks every one of them up, and a solver that names its offsets is half as slow again.
 */
export async function bundle(script: string) {
  const file = join(root, 'node_modules/.cache/gravity-stack-bench', `${script}-${process.pid}.mjs`)
  const built = await rolldown({
    input: join(root, `bench/${script}.ts`),
    platform: 'node',
    external: /^[^./]/,
    plugins: [
      {
        // Files named inside node_modules stay outside the bundle too: WebAssembly is loaded from beside them.
        name: 'keep-packages-outside',
        resolveId(id, importer) {
          if (!importer || !id.includes('node_modules')) return null
          return { id: resolve(dirname(importer), id), external: 'absolute' }
        },
      },
    ],
    logLevel: 'warn',
  })
  await built.write({ file, format: 'esm', codeSplitting: false, minify: { compress: true } })
  process.on('exit', () => rmSync(file, { force: true }))
  return file
}

export type Outcome<J extends Job> = J extends { kind: 'errors' }
  ? number[][]
  : J extends { kind: 'scene cost' }
    ? number[]
    : J extends { kind: 'pour cost' }
      ? Cost | AtLeast
      : number

/** Seconds of processor that jobs have taken in all. */
export const spent = { seconds: 0 }

/** The outcome of a job, or null when it took longer than `limit` milliseconds. */
export function runJob<J extends Job>(child: string, job: J, limit = 300_000): Promise<Outcome<J> | null> {
  const flags =
    job.kind === 'allocation' ? ['--expose-gc', '--min-semi-space-size=256', '--max-semi-space-size=256'] : []
  return new Promise((resolve, reject) => {
    const options = { cwd: root, encoding: 'utf8' as const, timeout: limit, killSignal: 'SIGKILL' as const }
    execFile(process.execPath, [...flags, child, JSON.stringify(job)], options, (error, out, err) => {
      if (error?.killed) {
        spent.seconds += limit / 1000
        return resolve(null)
      }
      if (error) return reject(new Error(`${JSON.stringify(job)}\n${err}`))
      // JSON knows no Infinity: it writes null, and an error without bound is what that means here.
      const last = out.trimEnd().split('\n').at(-1) ?? ''
      const { outcome, seconds } = JSON.parse(last, (_, value) => value ?? Number.POSITIVE_INFINITY)
      spent.seconds += seconds
      resolve(outcome)
    })
  })
}
