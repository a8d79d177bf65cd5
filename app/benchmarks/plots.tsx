import { frontier, points, rounding } from '@/bench/publish/report'
import { engineOrder } from '@/lib/evidence/engines'
import { defaultCosts, plotTitle, results } from '@/lib/evidence/results'
import { Plot, type PlotLine } from './plot'

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
      floor={rounding[unit]}
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
