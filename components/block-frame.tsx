'use client'

import { type CSSProperties, useEffect, useRef } from 'react'
import { at } from '@/lib/address'

/**
 * A block in a frame of its own, so that its window is as wide as the frame. The frame is empty until it is
 * about to be seen: a page full of blocks costs no more than those that somebody looks at.
 */
export function BlockFrame({
  name,
  title,
  className,
  style,
}: {
  name: string
  title: string
  className: string
  style?: CSSProperties
}) {
  const frame = useRef<HTMLIFrameElement>(null)

  useEffect(() => {
    const near = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        near.disconnect()
        frame.current!.src = at(`/blocks/${name}`)
      },
      { rootMargin: '200px' },
    )
    near.observe(frame.current!)
    return () => near.disconnect()
  }, [name])

  return (
    <>
      <iframe
        ref={frame}
        title={title}
        style={style}
        className={`w-full bg-stage [@media(scripting:none)]:hidden ${className}`}
      />
      <noscript>
        {/* Without script nothing keeps an example link from leading to a page that is not there. */}
        <iframe
          src={at(`/blocks/${name}`)}
          loading="lazy"
          tabIndex={-1}
          title={title}
          style={style}
          className={`pointer-events-none w-full bg-stage ${className}`}
        />
      </noscript>
    </>
  )
}
