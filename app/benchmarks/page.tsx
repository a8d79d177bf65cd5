import './benchmarks.css'
import type { Metadata } from 'next'
import type { ReactNode } from 'react'
import type { Results } from '@/bench/publish/report'
import { Heading } from '@/components/heading'
import { OnThisPage } from '@/components/on-this-page'
import { PageEnd } from '@/components/page-end'
import { PageTools } from '@/components/page-tools'
import { at } from '@/lib/address'
import { claim, dearer, lost, open, plotName, plotTitle, results, ties } from '@/lib/evidence/results'
import {
  circumstances,
  exception,
  floorTitle,
  inWords,
  listed,
  rowTitle,
  settingsByEngine,
  spreads,
} from '@/lib/evidence/words'
import { InBrowser } from './browser'
import { Drawn } from './drawn'
import { groups, headings } from './headings'
import { Legend } from './legend'
import { Markers } from './plot'
import { PlotTable } from './plot-table'
import { RunOnDevice } from './run-on-device'
import { Table } from './table'
import {
  cheaperTable,
  claimTable,
  frameTable,
  orderTable,
  pourTable,
  seedsTable,
  sizeTable,
  unmarkedTable,
  weightTable,
} from './tables'

export const metadata: Metadata = {
  title: 'Benchmarks',
  description:
    'Run time against error for Gravity Stack beside six other engines: named scenes, exact answers, every setting, raw data.',
  alternates: { canonical: '/benchmarks', types: { 'text/markdown': '/benchmarks.md' } },
}

export default function Benchmarks() {
  return (
    <div className="mx-auto grid w-full max-w-[88rem] flex-1 grid-cols-[minmax(0,1fr)] gap-10 px-4 sm:px-6 xl:grid-cols-[minmax(0,1fr)_12rem]">
      <main id="content" className="benchmarks min-w-0 pt-10 pb-20">
        <h1 className="text-balance font-semibold text-4xl tracking-[-0.03em]">Run time against error</h1>
        <div className="mt-3 max-w-3xl text-pretty text-lg text-muted-foreground leading-relaxed">
          <p>
            Each plot is one scene. The cost of a frame grows to the right, the error upwards, both in powers
            of ten: lower and further left is better. A mark is an engine at one choice of its settings; a
            line joins an engine’s best. The dashed edge is the frontier, the least error that any engine
            reaches at that cost. The right answers are formulas, or differential equations solved to 10⁻¹⁰.
            Piles have no right answer, so their overlap is measured, by an exact distance that no engine
            uses.
          </p>
        </div>
        <p className="mt-4 max-w-3xl text-muted-foreground text-sm leading-relaxed">
          Measured on {results.machine.cpu}, {results.machine.cores} cores, {results.machine.memoryGB} GB,{' '}
          {results.machine.system}, Node {results.machine.node}, on{' '}
          <time dateTime={results.date}>
            {new Date(results.date).toLocaleDateString('en', { dateStyle: 'long', timeZone: 'UTC' })}
          </time>
          , commit {results.commit}, {circumstances}. 60 frames a second, gravity 2,600 px/s², nothing asleep.
          Raw data: <Download file="results.json" />, <Download file="errors.csv" />,{' '}
          <Download file="costs.csv" />. To repeat it:{' '}
          <code className="rounded-md bg-muted px-1.5 py-0.5 font-mono text-[0.875em]">npm run bench</code>
        </p>
        <PageTools className="mt-4" twin="/benchmarks.md" source="app/benchmarks/page.tsx" />

        <Section id="claim">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            In {claim.length - lost.length - ties.length} of the {claim.length} rows below no engine, at any
            setting, is both cheaper and more accurate than Gravity Stack at its default setting.{' '}
            {ties.length > 0 &&
              `In ${inWords(ties.length)} more, ${listed(ties.map(rowTitle))}, a cheaper engine’s error is smaller too. But both are below ${listed([...new Set(ties.map(floorTitle))])}, where nobody can see a difference, so we call ${ties.length === 1 ? 'this a tie' : 'these ties'}. `}
            {lost.length > 0 && `The ${lost.length === 1 ? 'exception is' : 'exceptions are'} marked. `}
            {dearer.length > 0 &&
              `${dearer.length} settings have no mark in a plot: they were stopped, or not started, once it was clear that they cost more than ours, so none of them can be an exception. `}
            {open.length > 0 &&
              `Open, as they could not be played: ${settingsByEngine(open)
                .map((row) => row.join(': '))
                .join('; ')}. `}
            Two columns name the closest rival: the most accurate engine that costs no more, and the cheapest
            whose error is no larger. “Circle chains” is no engine of others: it is the method of this
            component’s first design.
          </p>
          <div className="mt-6">
            <Table {...claimTable} />
          </div>
          {lost.length > 0 && (
            <>
              <Title id="exceptions" />
              <ul className="max-w-3xl list-disc space-y-2 pl-5 text-muted-foreground leading-relaxed">
                {lost.map((verdict) => (
                  <li key={`${verdict.scene.name} ${verdict.measure}`}>{exception(verdict)}</li>
                ))}
              </ul>
            </>
          )}
        </Section>

        <Section id="plots">
          <Markers />
          <Legend />
          {groups.map((group) => (
            <section key={group.id}>
              <Title id={group.id} />
              <p className="max-w-3xl text-muted-foreground">{group.text}</p>
              <div className="mt-4 grid grid-cols-[minmax(0,1fr)] gap-4 has-[details[open]]:items-start md:grid-cols-2 2xl:grid-cols-3">
                {results.scenes
                  .filter((scene) => group.scenes.test(scene.name))
                  .flatMap((scene) =>
                    scene.measures.map((measure, i) =>
                      measure.ranked ? (
                        <PlotFigure key={`${scene.name} ${measure.name}`} scene={scene} measure={i} />
                      ) : null,
                    ),
                  )}
              </div>
            </section>
          ))}
        </Section>

        <Section id="order">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            Gravity Stack takes six sub-steps, and one where nothing moves. The table shows other numbers of
            sub-steps. An order of 2 means that twice the sub-steps leave a quarter of the error. Three kinds
            of errors are not listed, as sub-steps don’t change them. Flight, bounces and impacts are exact to
            rounding at any number. Overlap at rest is what a contact leaves alone. The contact residual
            follows no order.
          </p>
          <div className="mt-6">
            <Table {...orderTable} />
          </div>
        </Section>

        <Section id="pour">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            Each engine is listed at its default setting and at the one with the least overlap. Overlap at
            rest and the slowest rest are the worst of the seeds, the other columns the median. A pile is at
            rest once no chip moves faster than 7&nbsp;px/s or 0.14&nbsp;rad/s. The contact residual says how
            far forces and velocities are from the laws of contact, in weights of the pile.
          </p>
          <div className="mt-6">
            <Table {...pourTable} />
          </div>
        </Section>

        <Section id="chips">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            Pills are poured onto a stage. More pills get a larger one. Nothing sleeps. A cost is the mean of
            the first four seconds: fall, landing and rest. The claim’s table times a pour of up to 60 chips
            for six seconds, so more of it is rest. Each engine runs at its default setting. A pour was
            stopped after 24 seconds, or skipped if it clearly would take longer; &gt; marks a lower bound.
          </p>
          <div className="mt-6 grid grid-cols-[minmax(0,1fr)] items-start gap-4 2xl:grid-cols-[minmax(0,26rem)_minmax(0,1fr)]">
            <figure className="w-full max-w-xl rounded-2xl border bg-panel p-3">
              <Drawn />
            </figure>
            <Table {...sizeTable} />
          </div>
          <Title id="cheaper" />
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            Every engine whose frame costs less than ours, and its share of our cost. The plots above show how
            accurate it is at that price.
          </p>
          <div className="mt-4">
            <Table {...cheaperTable} />
          </div>
          <Title id="frames" />
          <div className="mt-4">
            <Table {...frameTable} />
          </div>
        </Section>

        <Section id="weight">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            The first column is what each engine needs for these scenes: bundled, minified and gzipped, with
            its WebAssembly. The second is how much it takes from the heap while 60 chips move, the third what
            a frame costs once all sleep. The whole component is weighed with the part of Motion that it uses,
            but without React and <code className="font-mono text-[0.875em]">cn</code>, which its project has
            anyway.
          </p>
          <div className="mt-6">
            <Table {...weightTable} />
          </div>
        </Section>

        <Section id="browser">
          <InBrowser download={<Download file="browser.json" />} />
        </Section>

        <Section id="device">
          <p className="max-w-3xl text-muted-foreground leading-relaxed">
            Gravity Stack, Matter and Rapier pour sixty pills at two settings each, in a worker of this page.
            All are warmed up before any is timed. Then they take turns, and each cost is the median of nine
            pours. It takes ten to twenty seconds on a fast laptop, a minute on a slow one. Close other
            programs first. Rapier’s 1.3 MB load only when you start it.
          </p>
          <div className="mt-6">
            <RunOnDevice />
          </div>
        </Section>

        <Section id="fair">
          <ul className="max-w-3xl list-disc space-y-2 pl-5 text-muted-foreground leading-relaxed">
            <li>
              Peers run as their makers mean them to. Pills are capsules in engines that have capsules. A
              hundred pixels are a metre in engines that reckon in metres. Bounce thresholds are set alike
              where they can be set.
            </li>
            <li>
              Planck and p2-es have no rounded boxes, so theirs are two boxes and four circles. Matter’s
              rounded corners are polygons. Where an engine’s own mass and inertia are off, they are set to
              the true ones; Matter is measured both ways.
            </li>
            <li>
              Rapier has no threshold below which bounces end, and Matter’s friction is not Coulomb’s. Both
              show in the scenes about them.
            </li>
            <li>
              “Circle chains” is the method of this component’s first design: up to three circles a chip, two
              passes of impulses, 120 steps a second. It was written afresh for this comparison.
            </li>
            <li>
              Engines take turns, each scene in a process of its own. A cost is the mean frame of a scene’s
              first six seconds; for pours by number of chips, and for all pours of 250 chips and more, of the
              first four. It is the median of {results.rounds} rounds{spreads}. Some are timed once: large
              pours at other settings than the default, engines whose run takes longer than 0.2&nbsp;s and
              more than twice as long as ours, and what there was no time to repeat. The raw data gives the
              rounds of each. Medians are compared, not single rounds. Differences under five per cent count
              as none, and so do errors below 10⁻⁹ px or 10⁻⁴ of a pile’s weight.
            </li>
          </ul>
          <Title id="seeds" />
          <p className="mb-4 max-w-3xl text-muted-foreground leading-relaxed">
            A pour starts from random places, so its error is taken over several starts, called seeds. The
            benchmark has limited time: slow engines get fewer seeds, and some of their settings are left out.
            Fewer seeds can only make an engine’s worst case look better. Box2D’s two builds move chips by the
            same bits, so one run of a seed stands for both.
          </p>
          <Table {...seedsTable} />
          {dearer.length > 0 && (
            <>
              <Title id="unmarked" />
              <p className="mb-4 max-w-3xl text-muted-foreground leading-relaxed">
                The table counts the settings that were stopped, or not started, once it was clear that they
                cost more than ours. The raw data lists them under “missing”, each with the reason and a lower
                bound of its cost.
              </p>
              <Table {...unmarkedTable} />
            </>
          )}
        </Section>
        <PageEnd path="/benchmarks" />
      </main>
      <OnThisPage headings={headings} />
    </div>
  )
}

function Section({ id, children }: { id: string; children: ReactNode }) {
  return (
    <section className="mt-16">
      <Title id={id} />
      {children}
    </section>
  )
}

/** The heading of that id. */
function Title({ id }: { id: string }) {
  const { depth, text } = headings.find((heading) => heading.id === id)!
  return depth === 2 ? (
    <Heading as="h2" id={id} className="mb-4 font-semibold text-2xl tracking-[-0.02em]">
      {text}
    </Heading>
  ) : (
    <Heading as="h3" id={id} className="mt-10 mb-1 scroll-mt-(--legend) font-semibold text-lg tracking-tight">
      {text}
    </Heading>
  )
}

function Download({ file }: { file: string }) {
  return (
    <a
      href={at(`/benchmarks/${file}`)}
      download
      className="underline decoration-foreground/35 underline-offset-4 hover:decoration-current"
    >
      {file}
    </a>
  )
}

function PlotFigure({ scene, measure }: { scene: Results['scenes'][number]; measure: number }) {
  const title = plotTitle(scene, measure)
  const seeds = scene.seeds > 1 ? `, ${scene.seeds} seeds` : ''
  return (
    <figure className="min-w-0 rounded-2xl border bg-panel p-3">
      <figcaption className="mb-1 px-1 font-medium text-sm">
        {title}
        <span className="font-normal text-muted-foreground">{seeds}</span>
      </figcaption>
      <Drawn scene={scene.name} measure={measure} />
      <PlotTable label={title} unit={scene.measures[measure].unit} name={plotName(scene, measure)} />
    </figure>
  )
}
