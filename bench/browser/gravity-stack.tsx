import * as React from 'react'
import { GravityStack, type GravityStackActions } from '../../components/ui/gravity-stack'
import { pills, type StageProps } from './chips'

export default function Stage({ chips, stagger, width, height, restless, look, upright }: StageProps) {
  const actions = React.useRef<GravityStackActions>(null)
  return (
    <GravityStack
      actionsRef={actions}
      stagger={stagger}
      upright={upright}
      onSettle={() => restless && actions.current?.shake()}
      style={{ width, height }}
      className="bg-neutral-100"
    >
      {pills(chips, look).map(({ pill }) => pill)}
    </GravityStack>
  )
}
