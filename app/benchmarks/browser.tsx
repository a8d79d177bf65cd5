import type { ReactNode } from 'react'
import { browserHead, browserResults, browserRows, three } from '@/lib/evidence/browser'
import { Table } from './table'

export function InBrowser({ download }: { download: ReactNode }) {
  const { date, commit, machine, idle, stages } = browserResults
  const { plan } = stages['gravity-stack']
  return (
    <>
      <p className="max-w-3xl text-muted-foreground leading-relaxed">
        Here the whole stage is measured in a page, from the server’s markup to rest. Releases are 150&nbsp;ms
        apart with 60 chips, which is the default, 10&nbsp;ms with 250 and 5&nbsp;ms with 1,000. Beside it
        stand two others. One is this component’s first design, its method written afresh, with a loop that
        never ends. The other is Matter as its users build it: Engine, Runner, a mouse constraint, and DOM
        elements whose transforms are written in each frame. Times come from the browser’s trace of the main
        thread and are the median of three drops. They count from the first frame of the drop until all lie
        still, or until two seconds after the last release where chips never do. A frame loop that does
        nothing takes {three(idle[1])}&nbsp;ms here, and {three(idle[4])}&nbsp;ms with the processor slowed
        four times.
      </p>
      <div className="mt-6">
        <Table
          label="In a browser"
          head={browserHead}
          rows={browserRows.map(({ name, goal, figures }) => [
            name,
            <span key="goal" className="whitespace-nowrap">
              {goal}
            </span>,
            ...figures.map(({ stage, text, missed }) => (
              <span key={stage} className="whitespace-nowrap">
                {/* Before the figure: on a narrow screen what comes after it is out of sight. */}
                {missed && <strong className="font-medium">missed: </strong>}
                {text}
              </span>
            )),
          ])}
        />
      </div>
      <p className="mt-4 max-w-3xl text-muted-foreground text-sm leading-relaxed">
        Measured in {machine.browser} on {machine.cpu}, {machine.cores} cores, {machine.memoryGB} GB,{' '}
        {machine.system}, on{' '}
        <time dateTime={date}>
          {new Date(date).toLocaleDateString('en', { dateStyle: 'long', timeZone: 'UTC' })}
        </time>
        , commit {commit}, without a graphics card: compositing is software.
        {plan && plan.commit !== commit && ` The cost of the plan is of commit ${plan.commit}.`} Raw data:{' '}
        {download}. To repeat it: <Code>npm run bench:browser</Code>
      </p>
    </>
  )
}

function Code({ children }: { children: ReactNode }) {
  return <code className="rounded-md bg-muted px-1.5 py-0.5 font-mono text-[0.875em]">{children}</code>
}
