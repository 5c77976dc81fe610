# shellcheck shell=sh disable=SC2034  # variables are shared with the other files
# Words of the PC side by which tests recognize a message.
# Tests read them here, so that wording can change.

msg_instead='of the folder instead'
msg_not_static='is not a static program for the robot'
msg_not_built='needs programs that are not built yet, for'
msg_not_file='is not a file or folder'
msg_no_folder='does not exist: specify the folder'
msg_nothing_to_build='nothing to build'
msg_link_out='is a link out of the folder'
msg_being_stopped='is already being stopped'
msg_robot_lost='the connection to the robot was lost'
msg_lost='was lost'
msg_if_driven='If the window drove it'
msg_password='rejected the password'
msg_completes='the robot completes a step that has started'
msg_other_key='another host key'
msg_refuses='refuses ssh connections'
msg_old_ssh='only old ssh algorithms'
msg_no_descriptor='requires an open file descriptor'
msg_unknown_host='is not known to this machine yet'
msg_has_other_key='has another key'
msg_interrupted='interrupted before the robot did anything'
