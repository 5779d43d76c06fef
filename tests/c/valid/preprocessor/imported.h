static int imported = 6;
