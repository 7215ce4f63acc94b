# SPDX-License-Identifier: BSD-3-Clause
# Debian's ros-image-pipeline, obtained and built: a real workspace to port and to measure with. Sourced after common.sh.
source "$TZC_ROOT/scripts/lib/debian_source.sh"
source "$TZC_ROOT/scripts/lib/workspace.sh"

pipeline_work=$TZC_BUILD/image-pipeline
pipeline_names=(depth_image_proc image_proc image_publisher image_rotate image_view stereo_image_proc)

# Builds TZC, fetches the packages into $pipeline (once), and builds them with catkin in $pipeline_work/original. Sets
# pipeline_packages to the fetched ones and pipeline_originals to those of the workspace.
prepare_image_pipeline() {
  say "Building TZC (once)"
  build_project -- tzc_roscpp tzc_core tzc_installed_messages tzc-msggen tzc-rewrite

  say "Fetching ros-image-pipeline from Debian's source archive"
  pipeline=$(debian_source ros-image-pipeline "$TZC_BUILD/sources")
  pipeline_packages=("${pipeline_names[@]/#/$pipeline/}")
  pipeline_originals=("${pipeline_names[@]/#/$pipeline_work/original/src/}")

  say "Building the original packages with catkin"
  fill_workspace "$pipeline_work/original" "${pipeline_packages[@]}"
  build_workspace "$pipeline_work/original"
}
