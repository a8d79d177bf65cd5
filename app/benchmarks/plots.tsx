import { frontier, points } from '@/bench/report'
import { defaultCosts, plotTitle, results } from './data'
import { engineOrder } from './engines'
import { Plot, type PlotLine } from './plot'

/** Where a line is drawn that nothing goes below: rounding, or a pile at rest. */
const floors: Record<string, number> = { weights: 1e-4, px: 1e-9, 'px/s': 1e-9, rad: 1e-9, relative: 1e-9 }

export function ScenePlot({ scene: name, measure }: { scene: string; measure: number }) {
  const scene = results.scenes.find((scene) => scene.name === name)!
  const { unit } = scene.measures[measure]
  const all = points(results, name, measure)
  const lines: PlotLine[] = engineOrder.map((engine) => ({
    engine,
    points: all.filter((point) => point.engine === engine).map(({ cost, error }) => ({ x: cost, y: error })),
  }))
  return (
    <Plot
      title={plotTitle(scene, measure)}
      lines={lines}
      xLabel="µs a frame"
      yLabel={`error, ${unit}`}
      floor={floors[unit]}
      frontier={frontier(all).map(({ cost, error }) => ({ x: cost, y: error }))}
    />
  )
}

export function SizePlot() {
  return (
    <Plot
      title="Cost by number of chips"
      joinAll
      xLabel="chips, all awake"
      yLabel="µs a frame"
      floor={1}
      lines={engineOrder.map((engine) => ({
        engine,
        points: defaultCosts
          .filter((row) => row.engine === engine && row.cost)
          .map((row) => ({ x: row.chips, y: row.cost?.mean ?? Number.NaN })),
      }))}
    />
  )
}
