import Matter from 'matter-js'
import * as React from 'react'
import { releasePose } from '../../registry/gravity-stack/stage/release'
import { conditions } from '../../scenes/scene'
import { walls } from '../engines/engine'
import { Field, type StageProps } from './chips'

/**
 * Matter with DOM elements as its users build it: Engine, Runner, a mouse constraint, and a loop of
 * transforms.
 */
export default function Stage({ chips, stagger, width, height }: StageProps) {
  const root = React.useRef<HTMLDivElement>(null)
  React.useEffect(() => {
    const element = root.current!
    const engine = Matter.Engine.create()
    engine.gravity.scale = conditions.gravity / 1e6
    const runner = Matter.Runner.create()
    const surface = { friction: conditions.friction, restitution: conditions.bounce }
    for (const wall of walls({ width, height })) {
      const options = { isStatic: true, ...surface }
      const body = Matter.Bodies.rectangle(wall.x, wall.y, 2 * wall.halfWidth, 2 * wall.halfHeight, options)
      Matter.Composite.add(engine.world, body)
    }
    const mouse = Matter.Mouse.create(element)
    Matter.Composite.add(engine.world, Matter.MouseConstraint.create(engine, { mouse }))
    const falling: { body: Matter.Body; chip: HTMLElement; width: number; height: number }[] = []
    const timers: number[] = []
    let request = 0
    const draw = () => {
      for (const { body, chip, width: w, height: h } of falling) {
        const { x, y } = body.position
        chip.style.transform = `translate(${x - w / 2}px, ${y - h / 2}px) rotate(${body.angle}rad)`
      }
      request = requestAnimationFrame(draw)
    }
    const release = (chip: HTMLElement, i: number) => {
      const { offsetWidth: w, offsetHeight: h } = chip
      const { x, y, angle } = releasePose(i, w, h, width, conditions.gravity, [])
      const options = { ...surface, angle, chamfer: { radius: h / 2 } }
      const body = Matter.Bodies.rectangle(x, y, w, h, options)
      Matter.Composite.add(engine.world, body)
      falling.push({ body, chip, width: w, height: h })
    }
    const observer = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        observer.disconnect()
        ;[...element.children].forEach((chip, i) => {
          timers.push(window.setTimeout(release, i * stagger, chip as HTMLElement, i))
        })
        Matter.Runner.run(runner, engine)
        draw()
      },
      { threshold: 0.25 },
    )
    observer.observe(element)
    return () => {
      observer.disconnect()
      timers.forEach(clearTimeout)
      cancelAnimationFrame(request)
      Matter.Runner.stop(runner)
      Matter.Engine.clear(engine)
    }
  }, [stagger, width, height])
  return <Field ref={root} chips={chips} width={width} height={height} />
}
