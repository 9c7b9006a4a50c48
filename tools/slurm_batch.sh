#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Plans every field of a file or folder on a cluster that runs Slurm: one job array of shards, then a job that merges.
#
#   tools/slurm_batch.sh SHARDS FIELDS DIR [OPTION OF selion batch]...
#
# SELION names the command (default: selion), SBATCH_OPTIONS what sbatch needs here ("--partition=long --time=8:00:00").
# FIELDS and DIR must lie where every node sees them. The same line again goes on where the last one ended: what is done
# is not done again. Prints the numbers of the two jobs. docs/cluster.md has more.
set -eu
if [ $# -lt 3 ]; then
  sed -n '3,11s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
shards=$1
fields=$2
folder=$3
shift 3
case $shards in
  *[!0-9]* | '' | 0*)
    echo "slurm_batch: '$shards' is no number of shards" >&2
    exit 2
    ;;
esac
SELION=${SELION:-selion}
command -v "$SELION" >/dev/null || { echo "slurm_batch: no command $SELION; name it in SELION" >&2; exit 2; }
command -v sbatch >/dev/null || { echo "slurm_batch: no sbatch here; run this where jobs are submitted" >&2; exit 2; }
mkdir -p "$folder/log"

# A word as the shell reads it back.
quoted() {
  printf "'%s' " "$(printf '%s' "$1" | sed "s/'/'\\\\''/g")"
}
job="$(quoted "$SELION")batch $(quoted "$fields")-o $(quoted "$folder")"
for option; do
  job="$job$(quoted "$option")"
done

# Each task plans its share on the processors that it was given. A task that is put back into the queue starts with the
# same line: --resume. Slurm ends a task by SIGTERM, which finishes the fields under way.
# shellcheck disable=SC2086
array=$(sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=selion-batch --array="1-$shards" --requeue --open-mode=append \
  --output="$folder/log/shard-%a.txt" --wrap="exec $job --resume --quiet --shard auto/$shards \
--threads \"\${SLURM_CPUS_PER_TASK:-1}\"")
array=${array%%;*}  # where there are several clusters, sbatch prints "number;cluster"
# After any end of the tasks: of one that failed, the merge says so, and a task put back into the queue is waited for.
# shellcheck disable=SC2086
merge=$(sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=selion-merge --dependency="afterany:$array" --open-mode=append \
  --output="$folder/log/merge.txt" --wrap="exec $(quoted "$SELION")batch --merge --overwrite -o $(quoted "$folder")")
echo "slurm_batch: $shards shards in job $array, merged by job ${merge%%;*}; their words are in $folder/log"
