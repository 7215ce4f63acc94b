#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the catkin workspace beside this file against tzc's devel space, or against an installed tzc.

usage: catkin_test.py {devel DEVEL_DIR | install BUILD_DIR}

A plain CMake project must get headers, too. The node must run; a second build must generate nothing; a changed definition must be generated again; the headers of
messages must be installed with the packages.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))


def run(command, **options):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if result.returncode:
        print(result.stdout[-6000:])
        sys.exit(f'failed: {" ".join(command)}')
    return result.stdout


def environment(prefix):
    variables = dict(os.environ, ROS_VERSION='1', PATH='/usr/bin:/bin:' + os.environ['PATH'])
    variables['CMAKE_PREFIX_PATH'] = os.pathsep.join([prefix] + [p for p in [os.environ.get('CMAKE_PREFIX_PATH')] if p])
    libraries = [f'{prefix}/lib', os.environ.get('LD_LIBRARY_PATH', '')]
    variables['LD_LIBRARY_PATH'] = os.pathsep.join(p for p in libraries if p)
    variables.pop('ROS_PACKAGE_PATH', None)
    return variables


def generated(output):
    return re.findall(r'Generating TZC headers from (\S+)', output)


def check(condition, text):
    if not condition:
        sys.exit(f'FAILED: {text}')
    print(f'ok: {text}')


def build(workspace, variables, *targets):
    return run(['catkin_make', '-C', workspace, '-j2', '-DCATKIN_ENABLE_TESTING=OFF', '-DPYTHON_EXECUTABLE=/usr/bin/python3',
                *targets],
               env=variables)


def test_workspace(workspace, prefix):
    shutil.copytree(f'{here}/src', f'{workspace}/src')
    variables = environment(prefix)
    build(workspace, variables, 'probe_node')  # alone: whatever its headers include must be there
    node = f'{workspace}/devel/lib/probe_node/probe_node'
    check(os.path.exists(node), 'a target that is built alone has the headers that its own include')
    run(['cmake', '--build', f'{workspace}/build', '--target', 'clean'], env=variables)
    shutil.rmtree(f'{workspace}/build')
    first = generated(build(workspace, variables))
    check({'probe_msgs/Probe.msg', 'probe_msgs/Ask.srv', 'plain_msgs/Samples.msg', 'lone_msgs/Scan.msg'} <= set(first),
          f'the first build generates headers from {len(first)} definitions')
    with open(f'{workspace}/devel/include/tzc/probe_msgs/PythonOnly.h', encoding='utf-8') as file:
        check('#error' in file.read(), 'a message that C++ cannot have costs the build nothing, and its header says why')
    check('all as expected' in run([node], env=variables), 'the node that uses them runs')
    check(generated(build(workspace, variables)) == [], 'a second build generates nothing')
    with open(f'{workspace}/src/probe_msgs/msg/Joint.msg', 'a', encoding='utf-8') as file:
        file.write('float32 torque\n')
    again = generated(build(workspace, variables))
    check(set(again) == {'probe_msgs/Joint.msg', 'probe_msgs/Probe.msg'},
          f'a changed definition is generated again, with what uses it, and nothing else: {again}')
    test_second_configuration(workspace, variables)
    build(workspace, variables, 'install')
    for header in ('probe_msgs/Probe.h', 'probe_msgs/AskRequest.h', 'plain_msgs/Samples.h'):
        check(os.path.exists(f'{workspace}/install/include/tzc/{header}'), f'tzc/{header} is installed')


def change(path, text):
    with open(path, 'a', encoding='utf-8') as file:
        file.write(text)


def test_second_configuration(workspace, variables):
    """What CMake finds in the devel space is not somebody else's because it is there already."""
    for package in ('plain_msgs', 'probe_node'):
        os.utime(f'{workspace}/src/{package}/CMakeLists.txt')
    change(f'{workspace}/src/plain_msgs/msg/Samples.msg', 'uint8 added\n')
    change(f'{workspace}/src/lone_msgs/msg/Return.msg', 'uint8 added\n')
    again = generated(build(workspace, variables))
    check('plain_msgs/Samples.msg' in again, f'CMake has run again: a package without TZC that has changed is generated again: {again}')
    check('lone_msgs/Scan.msg' in again, 'a message is generated again when one that it is made of has changed')
    for folder in (f'{workspace}/devel/include', f'{workspace}/build/early_node/tzc_messages'):
        with open(f'{folder}/tzc/plain_msgs/Samples.h', encoding='utf-8') as file:
            check('added' in file.read(), f'{folder} has the new definition')


def test_shared_prefix(workspace, variables, prefix):
    """TZC's folder is a system folder, which is searched last, only while it holds nobody else's headers."""
    def searched():
        with open(f'{workspace}/build/probe_node/CMakeFiles/probe_node.dir/flags.make', encoding='utf-8') as file:
            return re.findall(rf'(-I|-isystem ){re.escape(prefix)}/include(?=\s)', file.read())
    check(searched() == ['-isystem '], f'{prefix}/include holds TZC alone')
    os.mkdir(f'{prefix}/include/other_msgs')
    run(['cmake', f'{workspace}/build'], env=variables)
    check(searched() == ['-I'], f'{prefix}/include, with other packages, keeps its place before those below it')


def test_lone_user(build_folder, workspace, prefix):
    variables = environment(f'{workspace}/devel:{prefix}')
    run(['cmake', '-S', f'{here}/lone_user', '-B', build_folder, '-DPYTHON_EXECUTABLE=/usr/bin/python3',
         '-DCATKIN_ENABLE_TESTING=OFF'], env=variables)
    built = generated(run(['cmake', '--build', build_folder], env=variables))
    check('lone_msgs/Scan.msg' in built, 'a package that is configured alone generates headers of another one\'s messages')


def test_plain_project(build_folder, prefix):
    variables = environment(prefix)
    run(['cmake', '-S', f'{here}/plain_project', '-B', build_folder, '-DPYTHON_EXECUTABLE=/usr/bin/python3'], env=variables)
    run(['cmake', '--build', build_folder], env=variables)
    check(os.path.exists(f'{build_folder}/tzc_messages/tzc/own_msgs/Own.h'), 'a plain CMake project generates headers')
    again = subprocess.run(['cmake', '-DWITH_ANOTHER_FILE=ON', build_folder], env=variables, capture_output=True, text=True)
    told = ' '.join(again.stderr.split())  # CMake breaks lines where the length of the folder's name makes it
    check(again.returncode != 0 and 'msg/Other.msg' in told and 'Name all FILES' in told,
          'a second call for other files of the package is refused')


def test_moved_build(scratch):
    """Headers of a build folder that has got another name are made again; those that came from elsewhere are not."""
    script = f'{scratch}/ask.cmake'
    change(script, f"""include({here}/../../../cmake/tzc_generate_messages.cmake)
        set(CATKIN_DEVEL_PREFIX {scratch}/devel)
        foreach(prefix devel underlay)
          _tzc_is_own({scratch}/${{prefix}}/include some_msgs own)
          message("${{prefix}} ${{own}}")
        endforeach()
        """)
    for prefix in ('devel', 'underlay'):
        os.makedirs(f'{scratch}/{prefix}/include/tzc/some_msgs')
        change(f'{scratch}/{prefix}/include/tzc/some_msgs/made_by', f'{scratch}/was_here')
    told = run(['cmake', '-P', script]).split()
    check(told == ['devel', 'TRUE', 'underlay', 'FALSE'], f'headers of a build folder with another name: {told}')


def test_cross_build(scratch):
    """Packages of the workspace do not lie in the sysroot; those that are installed in it are found there."""
    for space, package in (('devel', 'near_msgs'), ('sysroot/opt/ros', 'far_msgs')):
        folder = f'{scratch}/{space}/share/{package}/cmake'
        os.makedirs(folder)
        change(f'{folder}/{package}-msg-paths.cmake', f'set({package}_MSG_INCLUDE_DIRS /{package}/msg)\n')
    script = f'{scratch}/ask.cmake'
    change(script, f"""cmake_minimum_required(VERSION 3.10)
        include({here}/../../../cmake/tzc_generate_messages.cmake)
        set(CMAKE_FIND_ROOT_PATH {scratch}/sysroot)
        set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
        set(CATKIN_DEVEL_PREFIX {scratch}/devel)
        set(CMAKE_PREFIX_PATH /opt/ros)
        foreach(package near_msgs far_msgs)
          _tzc_include_flags(${{package}} flags)
          message("${{flags}}")
        endforeach()
        """)
    told = run(['cmake', '-P', script]).split()
    check(told == ['-Inear_msgs:/near_msgs/msg', '-Ifar_msgs:/far_msgs/msg'], f'a cross build finds the folders of messages: {told}')


def main():
    kind, folder = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as scratch:
        prefix = folder
        if kind == 'install':
            prefix = f'{scratch}/prefix'
            run(['cmake', '--install', folder, '--prefix', prefix])
        os.mkdir(f'{scratch}/ws')
        test_plain_project(f'{scratch}/plain', prefix)
        os.mkdir(f'{scratch}/moved')
        test_moved_build(f'{scratch}/moved')
        os.mkdir(f'{scratch}/cross')
        test_cross_build(f'{scratch}/cross')
        if kind == 'install':  # what came with TZC is of an older version than the workspace's
            os.makedirs(f'{prefix}/include/tzc/plain_msgs')
            change(f'{prefix}/include/tzc/plain_msgs/Samples.h', '#error the headers of another version\n')
        test_workspace(f'{scratch}/ws', prefix)
        if kind == 'install':
            test_shared_prefix(f'{scratch}/ws', environment(prefix), prefix)
        test_lone_user(f'{scratch}/lone', f'{scratch}/ws', prefix)


main()
