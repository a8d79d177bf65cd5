import { GravityStackActionsDemo } from '../../registry/examples/gravity-stack-actions-demo'
import { GravityStackAvatarsDemo } from '../../registry/examples/gravity-stack-avatars-demo'
import { GravityStackDemo } from '../../registry/examples/gravity-stack-demo'
import { GravityStackElevationDemo } from '../../registry/examples/gravity-stack-elevation-demo'
import { GravityStackFooterDemo } from '../../registry/examples/gravity-stack-footer-demo'
import { GravityStackLinksDemo } from '../../registry/examples/gravity-stack-links-demo'
import { GravityStackShapesDemo } from '../../registry/examples/gravity-stack-shapes-demo'
import { GravityStackTagCloudDemo } from '../../registry/examples/gravity-stack-tag-cloud-demo'
import { GravityStackTintedDemo } from '../../registry/examples/gravity-stack-tinted-demo'

const demos = [
  GravityStackActionsDemo,
  GravityStackAvatarsDemo,
  GravityStackDemo,
  GravityStackElevationDemo,
  GravityStackFooterDemo,
  GravityStackLinksDemo,
  GravityStackShapesDemo,
  GravityStackTagCloudDemo,
  GravityStackTintedDemo,
]

/** One of the docs' demos, by its number. */
export default function Demo({ chips, width }: { chips: number; width: number }) {
  const One = demos[chips]
  return (
    <div style={{ width }}>
      <One />
    </div>
  )
}
