import { docs } from '@/lib/docs'
import { docMarkdown } from '@/lib/markdown'
import { componentFile, componentSource } from '@/lib/source'

export const dynamic = 'force-static'

export function GET() {
  const source = `# ${componentFile}\n\n\`\`\`tsx\n${componentSource()}\`\`\`\n`
  return new Response([...docs.map(docMarkdown), source].join('\n'))
}
