import type { ComponentProps, ComponentType } from 'react'
import * as React from 'react'
import * as runtime from 'react/jsx-runtime'
import * as ReactDOM from 'react-dom'
import { at } from '@/lib/address'
import { siteUrl, version } from '@/site.config.mjs'
import { Changelog } from './changelog'
import { Command } from './command'
import { ComponentPreview } from './component-preview'
import { ComponentSource } from './component-source'
import { CopyButton } from './copy-button'
import { ElevationLadder } from './elevation-ladder'
import { ElevationSource } from './elevation-source'
import { Heading } from './heading'
import { Install, InstallWay } from './install'
import { LiveFigure } from './lab'
import { Prompt } from './prompt'
import { ActionsTable, PropsTable } from './props-table'
import { ChipCounts, FuzzTable, HardScenesTable, ScenesTable, SlideWords } from './scenes-table'
import { ScrollTable } from './scroll-table'

const components: Record<string, unknown> = {
  a: ({ href, ...props }: ComponentProps<'a'>) => (
    <a href={href?.startsWith('/') ? at(href) : href} {...props} />
  ),
  h2: (props: ComponentProps<'h2'>) => <Heading as="h2" {...props} />,
  h3: (props: ComponentProps<'h3'>) => <Heading as="h3" {...props} />,
  // rehype-pretty-code wraps each block in a figure.
  figure: ({ children, title: _, ...props }: ComponentProps<'figure'>) => (
    <figure
      {...props}
      className="code relative overflow-hidden rounded-xl border bg-panel max-sm:not-has-[figcaption]:pt-7"
    >
      <CopyButton className="absolute top-1 right-1.5 bg-panel" />
      {children}
    </figure>
  ),
  figcaption: ({ children }: ComponentProps<'figcaption'>) => (
    <figcaption className="border-b px-4 py-3 pr-12 font-mono text-muted-foreground text-xs">
      {children}
    </figcaption>
  ),
  pre: ({ children }: ComponentProps<'pre'>) => (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a block that scrolls must be reachable
    <pre tabIndex={0}>{children}</pre>
  ),
  // A short name stays in one piece; what has words may break between them.
  code: ({ children, ...props }: ComponentProps<'code'>) => (
    <code
      {...props}
      className={
        typeof children === 'string' && /^(\S{1,28}|.{1,12})$/.test(children)
          ? children.length > 16
            ? 'sm:whitespace-nowrap max-sm:wrap-anywhere'
            : 'whitespace-nowrap'
          : undefined
      }
    >
      {children}
    </code>
  ),
  table: ({ children, 'aria-label': label = 'Table' }: ComponentProps<'table'>) => (
    <ScrollTable label={label}>{children}</ScrollTable>
  ),
  // On a phone the two cells of a row stand one below the other, and their heads would say nothing there.
  thead: (props: ComponentProps<'thead'>) => (
    <thead className="max-sm:not-has-[>tr>:nth-child(3)]:sr-only" {...props} />
  ),
  tr: (props: ComponentProps<'tr'>) => (
    <tr
      className="in-[tbody]:last:border-0 border-b max-sm:not-has-[>:nth-child(3)]:wrap-anywhere max-sm:not-has-[>:nth-child(3)]:flex max-sm:not-has-[>:nth-child(3)]:flex-col max-sm:not-has-[>:nth-child(3)]:py-1"
      {...props}
    />
  ),
  th: (props: ComponentProps<'th'>) => (
    <th scope="col" className="px-2.5 py-1 font-medium text-muted-foreground sm:px-4 sm:py-2.5" {...props} />
  ),
  td: (props: ComponentProps<'td'>) => (
    <td
      className="px-2.5 py-1 align-baseline max-sm:first:nth-last-2:font-medium sm:min-w-28 sm:px-4 sm:py-2.5 sm:first:min-w-0"
      {...props}
    />
  ),
  ActionsTable,
  Changelog: () => <Changelog components={components as never} />,
  Command,
  AddNamespace: () => (
    <Command label="namespace" run={`shadcn@latest registry add @liten=${siteUrl}/r/{name}.json`} />
  ),
  PinVersion: () => (
    <Command
      label="this version"
      run={`shadcn@latest registry add @liten=${siteUrl}/r/${version}/{name}.json`}
    />
  ),
  ChipCounts,
  SlideWords,
  AddCommand: ({ name }: { name: string }) => (
    <Command label={`add ${name}`} run={`shadcn@latest add ${siteUrl}/r/${name}.json`} />
  ),
  ComponentPreview,
  ComponentSource,
  ElevationLadder,
  ElevationSource,
  FuzzTable,
  HardScenesTable,
  Install,
  InstallWay,
  LiveFigure,
  Prompt,
  PropsTable,
  ScenesTable,
}

/** Runs the function body that contentlayer compiles a page to, on the server: no MDX reaches the browser. */
export function Mdx({ code }: { code: string }) {
  const scope = { React, ReactDOM, _jsx_runtime: runtime }
  const Content: ComponentType<{ components: unknown }> = new Function(...Object.keys(scope), code)(
    ...Object.values(scope),
  ).default
  return (
    <div className="prose">
      <Content components={components} />
    </div>
  )
}
