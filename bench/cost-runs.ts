// Costs are measured in processes of their own, started in turn so that a busy moment of the machine hits all alike.
import { execFileSync } from 'node:child_process'
import { mkdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import type { Setting } from './engine'
import { median } from './film'

export type Cost = {
  mean: number
  pour: number
  settled: number
  p50: number
  p95: number
  worst: number
}
export type Contestant = { engine: string; setting: Setting; chips: number; kind?: string }

const root = dirname(dirname(fileURLToPath(import.meta.url)))

/** Bundles the child as an app would be: a development loader wraps functions, and that costs time. */
export async function bundleChild() {
  const folder = join(root, 'node_modules/.cache/gravity-stack-bench')
  mkdirSync(folder, { recursive: true })
  const outfile = join(folder, `cost-${process.pid}.mjs`)
  await build({
    entryPoints: [join(root, 'bench/cost-child.ts')],
    outfile,
    bundle: true,
    format: 'esm',
    platform: 'node',
    target: 'es2022',
    packages: 'external',
    plugins: [
      {
        // Files named inside node_modules stay outside the bundle too: WebAssembly is loaded from beside them.
        name: 'keep-packages-outside',
        setup(context) {
          context.onResolve({ filter: /node_modules/ }, (args) => ({
            path: join(args.resolveDir, args.path),
            external: true,
          }))
        },
      },
    ],
    logLevel: 'error',
  })
  return outfile
}

/** Medians over the pours of one process. */
export function measureCost(child: string, contestant: Contestant, milliseconds: number): Cost {
  const { engine, setting, chips, kind = 'pills' } = contestant
  const args = [child, engine, JSON.stringify(setting), String(chips), kind, String(milliseconds)]
  const out = execFileSync(process.execPath, args, {
    cwd: root,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  })
  const runs = JSON.parse(out.slice(out.lastIndexOf('\n[') + 1)) as Cost[]
  return medianCost(runs)
}

export function medianCost(costs: Cost[]): Cost {
  const of = (key: keyof Cost) => median(costs.map((cost) => cost[key]))
  return {
    mean: of('mean'),
    pour: of('pour'),
    settled: of('settled'),
    p50: of('p50'),
    p95: of('p95'),
    worst: of('worst'),
  }
}
