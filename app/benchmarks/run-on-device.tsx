'use client'

import { useEffect, useRef, useState } from 'react'
import { looks, settingTitle } from '@/lib/evidence/engines'
import { figure } from '@/lib/figure'
import { EngineName, Plot } from './plot'
import type { DeviceNews, DevicePoint } from './run-worker'
import { Table } from './table'

type Progress = { done: number; total: number; engine: string }

export function RunOnDevice() {
  const worker = useRef<Worker | null>(null)
  const [state, setState] = useState<'idle' | 'running' | 'done' | 'failed'>('idle')
  const [progress, setProgress] = useState<Progress | null>(null)
  const [why, setWhy] = useState('')
  const [points, setPoints] = useState<DevicePoint[]>([])

  const stop = () => {
    worker.current?.terminate()
    worker.current = null
  }
  const fail = (reason: string) => {
    stop()
    setWhy(reason)
    setState('failed')
  }
  useEffect(() => () => worker.current?.terminate(), [])

  const start = () => {
    stop()
    setPoints([])
    setProgress(null)
    setState('running')
    let started: Worker
    try {
      started = new Worker(new URL('./run-worker.ts', import.meta.url), { type: 'module' })
    } catch (error) {
      return fail(String(error))
    }
    worker.current = started
    started.onmessage = ({ data }: MessageEvent<DeviceNews>) => {
      if (data.kind === 'progress') setProgress(data)
      if (data.kind === 'point') setPoints((before) => [...before, data.point])
      if (data.kind === 'failed') fail(data.why)
      if (data.kind === 'done') {
        setState('done')
        stop()
      }
    }
    started.onerror = ({ message }) => fail(message || 'the worker could not be loaded')
  }

  const cancel = () => {
    stop()
    setState('idle')
  }

  return (
    <div data-state={state}>
      <div className="flex flex-wrap items-center gap-4">
        <button
          type="button"
          data-print="hide"
          onClick={state === 'running' ? cancel : start}
          className="rounded-full bg-foreground px-5 py-2.5 font-medium text-background text-sm"
        >
          {state === 'running'
            ? 'Cancel'
            : state === 'failed' || points.length > 0
              ? 'Run again'
              : 'Run on this device'}
        </button>
        {state === 'running' && (
          <>
            <progress
              aria-label="Benchmark"
              max={progress?.total ?? 1}
              value={progress?.done ?? 0}
              className="h-2 w-48 accent-(--gravity-stack)"
            />
            <span className="text-muted-foreground text-sm">
              {progress ? looks[progress.engine].title : 'Loading'}
            </span>
          </>
        )}
        <p role="status" className="text-muted-foreground text-sm">
          {state === 'done' && 'Done.'}
          {state === 'failed' && `It stopped. ${why}`}
        </p>
      </div>
      {points.length > 0 && (
        <div className="mt-6 grid grid-cols-[minmax(0,1fr)] items-start gap-4 md:grid-cols-2 xl:max-w-5xl">
          {(['rest', 'during'] as const).map((measure) => {
            const title = measure === 'rest' ? 'Overlap at rest' : 'Overlap during the pour'
            return (
              <figure key={measure} className="min-w-0 rounded-2xl border bg-panel p-3">
                <figcaption className="mb-1 px-1 font-medium text-sm">{title}</figcaption>
                <Plot
                  title={title}
                  xLabel="µs a frame"
                  yLabel="px"
                  lines={['gravity-stack', 'matter-js', 'rapier'].map((engine) => ({
                    engine,
                    points: points
                      .filter((point) => point.engine === engine)
                      .map((point) => ({ x: point.cost, y: point[measure] })),
                  }))}
                />
              </figure>
            )
          })}
          <div className="min-w-0 md:col-span-2">
            <Table
              label="Results of this device"
              head={['Engine', 'Setting', 'µs', 'At rest, px', 'During, px']}
              numbers={[2, 3, 4]}
              rows={points.map((point) => [
                <EngineName key="engine" engine={point.engine} />,
                settingTitle(point.setting),
                figure(point.cost),
                figure(point.rest),
                figure(point.during),
              ])}
            />
          </div>
        </div>
      )}
    </div>
  )
}
