`define PEER_STAGES 2
