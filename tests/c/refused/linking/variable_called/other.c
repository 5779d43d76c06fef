int turn = 3;
