export { Site as default } from '@/components/site'
