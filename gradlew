#!/bin/sh
# Front door of the build: finds a Gradle and a JDK that fit together on this machine, then runs the build.
#   0. the Gradle that BRICKLESS_GRADLE names   1. the one pinned in gradle/wrapper/gradle-wrapper.properties, if installed or downloadable
#   2. else `gradle` on the PATH   3. else Debian's package   4. else one clear line
# `./gradlew simulate` passes the simulation's own exit status on (0 fine, 1 the program failed, 2 bad input).
# `path/to/gradlew -p DIR …` builds another project with the same Gradle and JDK.
set -u
home=$(cd "$(dirname "$0")" && pwd -P)
caller=$(pwd -P)
fail() { echo "gradlew: $*" >&2; exit 1; }

# ---- which Gradle
url=$(sed -n 's/^distributionUrl=//p' "$home/gradle/wrapper/gradle-wrapper.properties" | sed 's/\\//g')
name=$(basename "$url" .zip)
release=${name%-bin}
dists=${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/$name
find_pinned() {
    for candidate in "$dists"/*/"$release"/bin/gradle; do
        [ -x "$candidate" ] && echo "$candidate" && return
    done
}
download_pinned() {
    command -v curl >/dev/null 2>&1 && command -v unzip >/dev/null 2>&1 || return 1
    curl -sfIL --connect-timeout 4 --max-time 8 -o /dev/null "$url" || return 1
    echo "gradlew: downloading $url" >&2
    mkdir -p "$dists/brickless.part" &&
        curl -sfL --connect-timeout 4 -o "$dists/brickless.part/dist.zip" "$url" &&
        unzip -q -o "$dists/brickless.part/dist.zip" -d "$dists/brickless.part" &&
        rm "$dists/brickless.part/dist.zip" && mv "$dists/brickless.part" "$dists/brickless"
}
gradle=${BRICKLESS_GRADLE:-}
if [ -z "$gradle" ]; then gradle=$(find_pinned); fi
if [ -z "$gradle" ] && [ "${BRICKLESS_OFFLINE:-}" != true ] && download_pinned; then gradle=$(find_pinned); fi
if [ -z "$gradle" ]; then gradle=$(command -v gradle || true); fi
if [ -z "$gradle" ] && command -v apt-get >/dev/null 2>&1 && [ "$(id -u)" = 0 ]; then
    echo "gradlew: installing Debian's gradle package" >&2
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq gradle; } >/dev/null 2>&1
    gradle=$(command -v gradle || true)
fi
[ -n "$gradle" ] || fail "no Gradle: the pinned one cannot be downloaded ($url) and none is on the PATH; install Gradle 8 or newer, or Debian's 'gradle' package"

# ---- which JDK: every Gradle since 7.3 runs on 17, many on no JDK younger than themselves; Debian's 4.4.1 compiles on 17 to 20
oldest=17
case "$(readlink -f "$gradle")" in
    "$dists"/*) ranges=25 ;;
    /usr/share/gradle/*) ranges=20 ;;
    *) ranges='21 25' ;;
esac
major() { "$1/bin/java" -XshowSettings:properties -version 2>&1 | sed -n 's/^ *java.specification.version = //p'; }
fits() { [ -x "$1/bin/javac" ] && v=$(major "$1") && [ "${v%%.*}" -ge $oldest ] 2>/dev/null && [ "${v%%.*}" -le "$newest" ]; }
pick_jdk() {
    on_path=$(command -v javac || true)
    [ -n "$on_path" ] && on_path=$(dirname "$(dirname "$(readlink -f "$on_path")")")
    for newest in $ranges; do
        for jdk in "${JAVA_HOME:-}" "$on_path" /usr/lib/jvm/* /Library/Java/JavaVirtualMachines/*/Contents/Home "$HOME"/.sdkman/candidates/java/*; do
            [ -n "$jdk" ] && fits "$jdk" && echo "$jdk" && return
        done
    done
}
JAVA_HOME=$(pick_jdk)
[ -n "$JAVA_HOME" ] || fail "no JDK from $oldest to ${ranges##* } found for $gradle; set JAVA_HOME to one"
export JAVA_HOME

# ---- run
simulate=no quiet=-q elsewhere=no
for argument in "$@"; do
    case "$argument" in
        -p | --project-dir | --project-dir=*) elsewhere=yes ;;
        simulate) simulate=yes ;;
        -i | --info | -d | --debug | -s | --stacktrace | --console*) quiet= ;;
    esac
done
if [ $elsewhere = yes ]; then
    exec "$gradle" "$@"
fi
if [ $simulate = no ]; then
    exec "$gradle" -p "$home" "$@"
fi
status=$home/build/simulate.status
rm -f "$status"
[ -d "$home/build/install" ] || echo "gradlew: building Brickless first (about a minute)" >&2
# Debian's gradle script prints the JDK's version first; the simulation's own lines should stand alone.
{
    "$gradle" -p "$home" $quiet -PfrontDoor "-Dbrickless.callerDir=$caller" "$@" 2>&1 1>&3 |
        grep --line-buffered -vE '^(openjdk version|OpenJDK (Runtime|64-Bit))' >&2
} 3>&1
[ -f "$status" ] && exit "$(cat "$status")"
exit 1
