import { GravityStack } from '@/components/ui/gravity-stack'

const links = {
  'Flexible boxes': 'https://developer.mozilla.org/docs/Web/CSS/Guides/Flexible_box_layout',
  Containment: 'https://developer.mozilla.org/docs/Web/CSS/Guides/Containment',
  'Pointer events': 'https://developer.mozilla.org/docs/Web/API/Pointer_events',
  'Resize observer': 'https://developer.mozilla.org/docs/Web/API/ResizeObserver',
  'Reduced motion':
    'https://developer.mozilla.org/docs/Web/CSS/Reference/At-rules/@media/prefers-reduced-motion',
  'Print styles': 'https://developer.mozilla.org/docs/Web/CSS/Guides/Media_queries/Printing',
  'Scroll margins': 'https://developer.mozilla.org/docs/Web/CSS/Reference/Properties/scroll-margin',
}

/** A press follows the link, a drag tosses it; Tab goes from chip to chip. */
export function GravityStackLinksDemo() {
  return (
    <GravityStack className="h-80">
      {Object.entries(links).map(([title, address]) => (
        <a
          key={address}
          href={address}
          className="rounded-lg border border-neutral-300 bg-white px-4 py-2 font-medium text-neutral-900 text-sm underline decoration-neutral-400 underline-offset-4 hover:decoration-current focus-visible:-outline-offset-2 dark:border-neutral-700 dark:bg-neutral-900 dark:text-neutral-100"
        >
          {title}
        </a>
      ))}
    </GravityStack>
  )
}
