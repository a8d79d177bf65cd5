'use client'

import { type CSSProperties, useEffect, useRef, useState } from 'react'
import { at } from '@/lib/address'

/**
 * A block in a frame of its own, so that its window is as wide as the frame. The frame is made when it is
 * about to be seen: even an empty frame takes the browser as long as a small page.
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
  const place = useRef<HTMLDivElement>(null)
  const [seen, setSeen] = useState(false)

  useEffect(() => {
    const near = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        near.disconnect()
        setSeen(true)
      },
      { rootMargin: '200px' },
    )
    near.observe(place.current!)
    return () => near.disconnect()
  }, [])

  return (
    <>
      <div
        ref={place}
        data-slot="block-frame"
        style={style}
        className={`bg-stage [@media(scripting:none)]:hidden ${className}`}
      >
        {seen && <iframe src={at(`/blocks/${name}`)} title={title} className="block size-full" />}
      </div>
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
